// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/norm.hpp"
#include "kernels/smoothing/power.hpp"

namespace sphk {

/// Linear quartic kernel LIQ(x_s), V10 App. A: F - q below q = x_s and, above, the quartic that vanishes with two
/// derivatives at 1 and continues value, slope -1 and curvature 0 at x_s. With s = 1-q and s_c = 1-x_s that quartic is
/// s^3 (1/s_c^2 - s/(2 s_c^3)), V10's A to E expanded in q.
struct Liq {
  static constexpr const char* name = "liq";
  static constexpr double spacings = 3.1915;
  static constexpr int flops = 15;

  /// x_s in [0, 1): the edge of the linear core; V10's choice is 0.3.
  KOKKOS_INLINE_FUNCTION constexpr explicit Liq(double core_edge = 0.3)
      : x_s(core_edge), cubic(1 / power<2>(1 - core_edge)), quartic(-0.5 / power<3>(1 - core_edge)) {}

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION Shape<T> operator()(T q) const {
    using R = lane_t<T>;
    const T s = truncated(R(1), sphk::max(q, T(R(x_s))));
    const T s2 = s * s, b = R(quartic) * s;
    return {s2 * s * (R(cubic) + b) - sphk::min(q - R(x_s), T(R(0))), s2 * (R(-3 * cubic) - R(4) * b)};
  }
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T w(T q) const {
    return (*this)(q).w;
  }
  KOKKOS_INLINE_FUNCTION constexpr double norm(int dimension) const {
    const double s_c = 1 - x_s;
    const double centre = power<3>(s_c) * (cubic + quartic * s_c) + x_s;
    const double outside = cubic * power_moment(3, dimension, 1, x_s) + quartic * power_moment(4, dimension, 1, x_s);
    return norm_from_moment(dimension, outside + core_moment(dimension, centre, -1, x_s));
  }

  double x_s, cubic, quartic;
};

}  // namespace sphk
