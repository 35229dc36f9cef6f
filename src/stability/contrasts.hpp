// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/engine/particle_set.hpp"

namespace sphk {

/// By which factors gas changes from a place to those beside it: the largest found; 1 in even gas.
struct Contrasts {
  double density = 1;  ///< of gas at one pressure, within a factor of 3
  double pressure = 1;
  double mass = 1;               ///< of particles
  std::size_t without_heat = 0;  ///< particles with u = 0
};

/// Measured on boxes of up to 16 particles, each against those on its sides, from masses, places and energies alone: a
/// sort of the particles, no sum over neighbours. Empty space counts as thin gas as cold as what lies beside it. Wants
/// finite numbers and positive masses.
Contrasts contrasts(const ParticleSet& gas);

}  // namespace sphk
