// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/norm.hpp"
#include "kernels/smoothing/power.hpp"

namespace sphk {

/// Schoenberg's B-splines of degree n = M-1 above the cubic one (Schoenberg 1946): M5, the quartic,
/// (1-q)^4 - 5(3/5-q)_+^4 + 10(1/5-q)_+^4, and M6, the quintic, (1-q)^5 - 6(2/3-q)_+^5 + 15(1/3-q)_+^5.
template <int M>
struct BSpline {
  static_assert(M == 5 || M == 6);
  static constexpr int n = M - 1;
  static constexpr char name[] = {'m', '0' + M, '\0'};
  static constexpr double spacings = n == 5 ? 2.8406 : 3.503;
  static constexpr int flops = truncated_powers_flops(n);

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION Shape<T> operator()(T q) const {
    return truncated_powers<n>(q, inner());
  }
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T w(T q) const {
    return truncated_powers_w<n>(q, inner());
  }
  KOKKOS_INLINE_FUNCTION constexpr double norm(int dimension) const {
    constexpr InnerPowers c = inner();
    return norm_from_moment(dimension, power_moment(n, dimension, 1) + c.c1 * power_moment(n, dimension, c.b1) +
                                           c.c2 * power_moment(n, dimension, c.b2));
  }

 private:
  /// Knots 1 - 2k/M and binomial coefficients (-1)^k (M over k), k = 1, 2.
  KOKKOS_INLINE_FUNCTION static constexpr InnerPowers inner() {
    return {1 - 2.0 / M, -M, 1 - 4.0 / M, M * (M - 1) / 2.0};
  }
};

}  // namespace sphk
