// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "src/engine/particle_set.hpp"

namespace sphk {

/// The units of a run's numbers, in cgs.
struct Units {
  double length = 1, mass = 1, time = 1;
  double velocity() const { return length / time; }
  /// What a number of that unit is in cgs.
  double to_cgs(const UnitExponents& exponents) const;
  bool operator==(const Units&) const = default;
};

enum class UnitOf { length, mass, time, velocity };

/// The cgs value of a unit: a name ("kpc", "Msun", "Gyr", "km/s"), a number of it ("1e10 Msun"), or a number alone,
/// which is in cgs. Throws InputError, a sentence with the names there are, where it is none of these or no positive
/// number.
double unit_in_cgs(UnitOf kind, std::string_view text);

/// The name of a unit by its cgs value, such as "kpc", "1e10 Msun" or "977.79 Myr": where it is within 1e-3 of a named
/// unit, or of a power of ten of a smaller one, that; else a number of the largest unit that it exceeds.
std::string unit_name(UnitOf kind, double cgs);

/// The units in words: "kpc, 1e10 Msun, km/s and 977.79 Myr"; "code units" where there are none.
std::string units_text(const std::optional<Units>& units);

/// How pictures name the unit of a quantity: "x", "t", "v", "m", "rho", "P", "u", "A" (the entropy function) or
/// "energy", for gas of that dimension and adiabatic index.
std::string unit_label(const Units& units, std::string_view quantity, int dimension, double gamma);

}  // namespace sphk
