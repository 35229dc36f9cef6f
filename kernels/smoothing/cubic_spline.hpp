// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/norm.hpp"
#include "kernels/smoothing/power.hpp"

namespace sphk {

/// Cubic spline (Monaghan & Lattanzio 1985), R10 eq 44: 1 - 6q^2 + 6q^3 for q <= 1/2, 2(1-q)^3 above. As truncated
/// powers: 2(1-q)_+^3 - (1-2q)_+^3.
struct CubicSpline {
  static constexpr const char* name = "cs";
  static constexpr double spacings = 2.2545;
  static constexpr int flops = 14;

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION Shape<T> operator()(T q) const {
    using R = lane_t<T>;
    const T outer = truncated(R(1), q), inner = truncated(R(1), R(2) * q);
    const T outer2 = outer * outer, inner2 = inner * inner;
    return {R(2) * (outer * outer2) - inner * inner2, R(6) * (inner2 - outer2)};
  }
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T w(T q) const {
    return (*this)(q).w;
  }
  KOKKOS_INLINE_FUNCTION constexpr double norm(int dimension) const {
    return norm_from_moment(dimension, 2 * power_moment(3, dimension, 1) - 8 * power_moment(3, dimension, 0.5));
  }
};

}  // namespace sphk
