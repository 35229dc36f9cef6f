// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/engine/particle_set.hpp"

namespace sphk {

/// The units that a run computes in, in those of its user: powers of two, so that nothing is rounded on the way in or
/// out. Distances, masses and speeds are then near 1, whatever the user's units: pair arithmetic in floats has no h^-4
/// out of its range, and small numbers that the engine adds mean the same in any unit.
struct Scale {
  int length = 0, mass = 0, time = 0;  ///< binary logarithms

  /// What a number of the run in these units is to be multiplied with for the user; 1 / that on the way in.
  double factor(const UnitExponents& unit) const;
  bool operator==(const Scale&) const = default;
};

inline constexpr UnitExponents length_unit{.length = 1}, mass_unit{.mass = 1}, time_unit{.time = 1},
    speed_unit{.length = 1, .time = -1}, specific_energy_unit{.length = 2, .time = -2},
    energy_unit{.length = 2, .mass = 1, .time = -2};

constexpr UnitExponents density_unit(int dimension) {
  return {.length = -1.0 * dimension, .mass = 1};
}

/// The scale of a gas: the distance between particles in its dense half, its median mass, and the root mean square of
/// its thermal and relative speeds. It follows the units: scaled numbers of equal gases are equal bit by bit where
/// their units differ by powers of two.
Scale scale_of(const ParticleSet& particles);

}  // namespace sphk
