// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/norm.hpp"
#include "kernels/smoothing/power.hpp"

namespace sphk {

/// Johnson's quadratic kernel, (1-q)^2: its slope grows towards the centre (V10 sec 3).
struct Johnson {
  static constexpr const char* name = "johnson";
  static constexpr double spacings = 2.2545;
  static constexpr int flops = 4;

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION Shape<T> operator()(T q) const {
    using R = lane_t<T>;
    const T s = truncated(R(1), q);
    return {s * s, R(-2) * s};
  }
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T w(T q) const {
    return (*this)(q).w;
  }
  KOKKOS_INLINE_FUNCTION constexpr double norm(int dimension) const {
    return norm_from_moment(dimension, power_moment(2, dimension, 1));
  }
};

}  // namespace sphk
