// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_MathematicalFunctions.hpp>

namespace sphk {

/// The gas of one particle, as free functions see it: code units, rho and P of the equations of motion.
struct GasValues {
  double rho, P, u, A, gamma;
};

/// Free functions eta, phi, zeta of the generalised equations (R10 eq 16-18). Any type with a name and such a value
/// serves; only ratios of values matter.
struct One {
  static constexpr const char* name = "1";
  KOKKOS_INLINE_FUNCTION static double value(const GasValues&) { return 1; }
};
struct DensityItself {
  static constexpr const char* name = "rho";
  KOKKOS_INLINE_FUNCTION static double value(const GasValues& gas) { return gas.rho; }
};
struct InverseEnergy {
  static constexpr const char* name = "1/u";
  KOKKOS_INLINE_FUNCTION static double value(const GasValues& gas) { return 1 / gas.u; }
};
/// A^(-1/gamma).
struct InverseEntropyRoot {
  static constexpr const char* name = "A^(-1/gamma)";
  KOKKOS_INLINE_FUNCTION static double value(const GasValues& gas) { return Kokkos::pow(gas.A, -1 / gas.gamma); }
};

}  // namespace sphk
