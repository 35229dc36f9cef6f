// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/engine/settings.hpp"
#include "src/schemes/catalogue.hpp"

namespace sphk {

/// Every scheme that a run may ask for, hidden ones too: those of this build, then those of modules (modules.hpp).
const Catalogue& known_schemes();
/// The scheme of that name. Throws InputError with the names that there are.
const SchemeEntry& scheme_entry(const std::string& name);

/// The neighbour number that goes with a kernel under a scheme: the scheme's own for its usual kernel, and where the
/// kernel wants more, as many as it wants.
double usual_neighbours(const SchemeFacts& scheme, const std::string& kernel, int dimension);

/// The settings with everything that was left to the scheme filled in. Throws InputError for numbers that the scheme
/// does not have, and names those that have them.
SimulationSettings resolved(SimulationSettings settings, int dimension, const SchemeEntry& scheme);
/// By the scheme that they name.
SimulationSettings resolved(const SimulationSettings& settings, int dimension);

/// The same kernel, neighbours, time-steps and numbers under another scheme, as far as it has the numbers.
SimulationSettings under_scheme(SimulationSettings settings, const std::string& scheme);

/// Declares the keys of all schemes, of [sph], [time] and of the sections of terms.
void declare_engine_keys(Settings& settings);
/// Makes these keys those of the chosen scheme: defaults are its own, for gas of that dimension, in flows that mix or
/// not; keys of other schemes go, and one that the user has set is an InputError that names the schemes that have it.
/// What a scene prefers of kernel and neighbours holds for the scheme that it prefers.
void adopt_scheme(Settings& settings, int dimension, bool mixes);
SimulationSettings simulation_settings(const Settings& settings);

}  // namespace sphk
