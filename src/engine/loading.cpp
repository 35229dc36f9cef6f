// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/loading.hpp"

#include <cmath>

#include "src/engine/geometry.hpp"

namespace sphk {

double support_of_even_gas(const ParticleSet& particles, const SimulationSettings& settings) {
  const int D = particles.dimension;
  double volume = 1;
  for (int d = 0; d < D; ++d) volume *= particles.box.size[d];
  return std::pow(settings.neighbours * volume / (static_cast<double>(particles.size()) * unit_sphere_volume(D)),
                  1.0 / D);
}

double support_cap(const ParticleSet& particles, const SimulationSettings& settings) {
  double diagonal2 = 0;
  bool open = false;
  for (int d = 0; d < particles.dimension; ++d) {
    diagonal2 += particles.box.size[d] * particles.box.size[d];
    open = open || !particles.box.periodic[d];
  }
  const double diagonal = std::sqrt(diagonal2);
  return open ? diagonal : diagonal + 2 * support_of_even_gas(particles, settings);
}

Given given_of(const SimulationSettings& settings) {
  Given given = settings.numbers;
  given.set(adiabatic_index.key, settings.gamma);
  return given;
}

bool has_own_steps(const SimulationSettings& settings) {
  return settings.steps == own_steps;
}

Parameters parameters_of(const ParticleSet& particles, const SimulationSettings& settings) {
  const double length = settings.own_units.value_or(Scale{}).factor(length_unit);
  return {.neighbours = settings.neighbours,
          .gamma = settings.gamma,
          .courant = settings.courant,
          .h_max = settings.h_max > 0 ? settings.h_max : support_cap(particles, settings) / length};
}

}  // namespace sphk
