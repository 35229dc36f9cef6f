// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "src/engine/simulation.hpp"
#include "src/schemes/catalogue.hpp"
#include "src/schemes/resolve.hpp"

namespace sphk {

/// The schemes that a user may ask for.
std::vector<std::string> scheme_names();
std::vector<std::string> kernel_names();

/// Smallest N_n for which S12 eq 11 has a root: V_D N_D w(0), the self term alone.
double min_neighbours(const std::string& kernel, int dimension);

/// Of the compiled recipe that serves these particles with these settings, which may leave things to the scheme.
SchemeDescription describe(const SimulationSettings& settings, const ParticleSet& particles);

/// Checks the particles and the settings (InputError), loads the device and computes the first density and rates. What
/// the settings leave open is the scheme's own.
std::unique_ptr<Simulation> make_simulation(const ParticleSet& particles, const SimulationSettings& settings);

}  // namespace sphk
