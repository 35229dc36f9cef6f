// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>

namespace sphk {

/// Integral of (b-q)^n q^(D-1) over q from a to b, D = 1, 2, 3, by writing q = b - (b-q).
KOKKOS_INLINE_FUNCTION constexpr double power_moment(int n, int dimension, double b, double a = 0) {
  if (dimension > 1) return b * power_moment(n, dimension - 1, b, a) - power_moment(n + 1, dimension - 1, b, a);
  double result = 1.0 / (n + 1);
  for (int k = 0; k <= n; ++k) result *= b - a;
  return result;
}

/// Integral of the linear core Q + P q times q^(D-1) over q from 0 to kappa.
KOKKOS_INLINE_FUNCTION constexpr double core_moment(int dimension, double Q, double P, double kappa) {
  double kappa_D = kappa;
  for (int k = 1; k < dimension; ++k) kappa_D *= kappa;
  return kappa_D * (Q / dimension + P * kappa / (dimension + 1));
}

/// N_D for a shape with the moment M = integral of w q^(D-1) over q: 1 / (S_D M), S_D = 2, 2 pi, 4 pi.
KOKKOS_INLINE_FUNCTION constexpr double norm_from_moment(int dimension, double moment) {
  constexpr double pi = 3.14159265358979323846;
  const double sphere = dimension == 1 ? 2 : dimension == 2 ? 2 * pi : 4 * pi;
  return 1 / (sphere * moment);
}

}  // namespace sphk
