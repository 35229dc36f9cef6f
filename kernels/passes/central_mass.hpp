// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/core/number.hpp"
#include "kernels/core/simd.hpp"
#include "kernels/core/vec.hpp"

namespace sphk {

inline constexpr Number central_mass{.key = "gravity.central_mass",
                                     .standard = 0,
                                     .meaning = "G M of a mass at the origin that pulls the gas; 0: none",
                                     .unit = {.length = 3, .time = -2}};
inline constexpr Number gravity_softening{.key = "gravity.softening",
                                          .standard = 0,
                                          .meaning = "of its potential - G M / sqrt(r^2 + softening^2)",
                                          .unit = {.length = 1}};

/// A mass at the origin, which pulls all particles and does not move.
struct CentralMass {
  double GM = 0, softening = 0;

  CentralMass() = default;
  explicit CentralMass(const Given& given) : GM(given[central_mass]), softening(given[gravity_softening]) {}

  /// G M / (r^2 + softening^2)^(3/2): the squared rate at which a particle circles; dv/dt = - that x.
  template <int D>
  KOKKOS_INLINE_FUNCTION double rate2(const Vec<double, D>& x) const {
    const double r2 = distance2(x);
    return GM / (r2 * Kokkos::sqrt(r2));
  }
  template <int D>
  KOKKOS_INLINE_FUNCTION double potential(const Vec<double, D>& x) const {
    return GM > 0 ? -GM / Kokkos::sqrt(distance2(x)) : 0;
  }
  /// `step`, or C over the rate of circling where that is shorter.
  template <int D>
  KOKKOS_INLINE_FUNCTION double limited(double step, double courant, const Vec<double, D>& x) const {
    return GM > 0 ? min(step, courant / Kokkos::sqrt(rate2(x))) : step;
  }

 private:
  template <int D>
  KOKKOS_INLINE_FUNCTION double distance2(const Vec<double, D>& x) const {
    double r2 = softening * softening;
    for (int d = 0; d < D; ++d) r2 += x[d] * x[d];
    return r2;
  }
};

}  // namespace sphk
