// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/schemes/catalogue.hpp"
#include "src/schemes/instantiation.hpp"

namespace sphk {

/// The compiled recipes of a scheme of known_schemes(), in so many dimensions.
const Instantiations& compiled_rows(const std::string& scheme, int dimension);
/// Those of all schemes and dimensions.
Instantiations compiled_rows();

/// A simulation under a scheme of one's own (make_simulation.hpp).
std::unique_ptr<Simulation> make_simulation(const ParticleSet& particles, const SimulationSettings& settings,
                                            const SchemeEntry& scheme, const Instantiations& rows);

}  // namespace sphk
