#pragma once

#include "src/schemes/instantiate.hpp"
#include "src/schemes/registry.hpp"

namespace sphk {

/// A simulation under a scheme of one's own (docs/examples/own_scheme.cpp): a struct with `facts` and a list of
/// Recipes, as those in src/schemes. It is compiled here, for 1D, 2D and 3D where its recipes have kernels there. The
/// settings leave `scheme` alone: it is this one. Throws InputError as the other make_simulation does.
template <class S>
std::unique_ptr<Simulation> make_simulation(const ParticleSet& particles, SimulationSettings settings = {}) {
  Instantiations rows;
  const auto append = [&](Instantiations&& some) {
    for (Instantiation& row : some) rows.push_back(std::move(row));
  };
  append(instantiate<S, 1>()), append(instantiate<S, 2>()), append(instantiate<S, 3>());
  settings.scheme = S::facts.name;
  return make_simulation(particles, settings, rows);
}

}  // namespace sphk
