// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/cubic_spline.hpp"

namespace sphk {

/// HYDRA's kernel (V10 sec 3): the cubic spline, but with dw frozen at its steepest value for q < 1/3, so that the
/// force between close particles does not fade. dw is not the derivative of w there, on purpose.
struct Hydra {
  static constexpr const char* name = "hydra";
  static constexpr double spacings = 2.2545;
  static constexpr int flops = CubicSpline::flops + 5;
  static constexpr double core = 1.0 / 3;

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION Shape<T> operator()(T q) const {
    return {CubicSpline{}.w(q), CubicSpline{}(sphk::max(q, T(lane_t<T>(core)))).dw};
  }
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T w(T q) const {
    return CubicSpline{}.w(q);
  }
  /// The cubic spline's own derivative.
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION Shape<T> with_own_derivative(T q) const {
    return CubicSpline{}(q);
  }
  KOKKOS_INLINE_FUNCTION constexpr double norm(int dimension) const { return CubicSpline{}.norm(dimension); }
};

}  // namespace sphk
