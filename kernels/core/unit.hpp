// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace sphk {

/// Powers in a unit: of length, mass, time, of volume (length^D) and of (mass/volume)^(1 - gamma), which the entropy
/// function has.
struct Unit {
  double length = 0, mass = 0, time = 0, volume = 0, adiabatic = 0;
};

}  // namespace sphk
