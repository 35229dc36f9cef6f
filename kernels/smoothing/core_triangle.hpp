// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/cubic_spline.hpp"

namespace sphk {

/// Core triangle, R10 eq 45: the cubic spline with a linear core below q = 1/3, where the spline is steepest. The core
/// continues value and slope, w(q) = cs(max(q, 1/3)) + slope min(q - 1/3, 0), so that no branch is needed.
struct CoreTriangle {
  static constexpr const char* name = "ct";
  static constexpr double spacings = 3.1265;
  static constexpr int flops = CubicSpline::flops + 5;
  static constexpr double core = 1.0 / 3;
  static constexpr double slope = -12 * core + 18 * core * core;

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION Shape<T> operator()(T q) const {
    using R = lane_t<T>;
    const Shape<T> outside = CubicSpline{}(sphk::max(q, T(R(core))));
    return {outside.w + R(slope) * sphk::min(q - R(core), T(R(0))), outside.dw};
  }
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T w(T q) const {
    return (*this)(q).w;
  }
  KOKKOS_INLINE_FUNCTION constexpr double norm(int dimension) const {
    constexpr double centre = 1 + 6 * core * core - 12 * core * core * core;
    const double outside = 2 * power_moment(3, dimension, 1, core) - 8 * power_moment(3, dimension, 0.5, core);
    return norm_from_moment(dimension, outside + core_moment(dimension, centre, slope, core));
  }
};

}  // namespace sphk
