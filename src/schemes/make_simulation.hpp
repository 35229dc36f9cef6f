// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/engine/recipe_parts.hpp"
#include "src/schemes/compiled_rows.hpp"
#include "src/schemes/instantiate.hpp"
#include "src/schemes/scheme_entry.hpp"

namespace sphk {

/// A simulation under a scheme of one's own (docs/examples/own_scheme.hpp): a struct with `facts` and a list of
/// Recipes, as those in src/schemes. It is compiled here, for 1D, 2D and 3D where its recipes have kernels there. The
/// settings leave `scheme` alone: it is this one. Throws InputError as the other make_simulation does.
template <class S>
std::unique_ptr<Simulation> make_simulation(const ParticleSet& particles, SimulationSettings settings = {}) {
  settings.scheme = S::facts.name;
  return make_simulation(particles, settings, scheme_entry<S>(), all_rows_of<S>());
}

}  // namespace sphk
