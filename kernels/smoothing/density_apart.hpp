// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/core_triangle.hpp"
#include "kernels/smoothing/cubic_spline.hpp"

namespace sphk {

/// One kernel for densities and another for forces: W, with its own derivative in h, is of the first, grad W of the
/// second, with its norm. R10 (sec 3.4.1) tried the cubic spline's density with the core triangle's forces.
template <class ForDensity, class ForForces>
struct DensityApart {
  static constexpr double spacings = ForForces::spacings;
  static constexpr int flops = ForDensity::flops + ForForces::flops;

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION Shape<T> operator()(T q) const {
    return {ForDensity{}.w(q), ForForces{}(q).dw};
  }
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T w(T q) const {
    return ForDensity{}.w(q);
  }
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION Shape<T> with_own_derivative(T q) const {
    return ForDensity{}(q);
  }
  KOKKOS_INLINE_FUNCTION constexpr double norm(int dimension) const { return ForDensity{}.norm(dimension); }
  KOKKOS_INLINE_FUNCTION constexpr double norm_of_forces(int dimension) const { return ForForces{}.norm(dimension); }
};

struct CoreTriangleForces : DensityApart<CubicSpline, CoreTriangle> {
  static constexpr const char* name = "ct-cs";
};

}  // namespace sphk
