// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "kernels/smoothing/shape.hpp"

namespace sphk {

/// A smoothing kernel that no list at compile time has, by the addresses of its functions. Host only.
struct OwnKernel {
  static constexpr const char* name = "one's own";
  static constexpr int flops = 0;
  std::string_view known_as = name;
  double spacings = 0;
  Shape<double> (*shape)(double q) = nullptr, (*shape_of_slope)(double q) = nullptr;
  double norms[3] = {}, force_norms[3] = {};

  template <class Kernel>
  static OwnKernel of() {
    const Kernel kernel{};
    OwnKernel own{.known_as = Kernel::name,
                  .spacings = Kernel::spacings,
                  .shape = +[](double q) { return Kernel{}(q); },
                  .shape_of_slope = +[](double q) { return sphk::with_own_derivative(Kernel{}, q); }};
    for (int D = 1; D <= 3; ++D) {
      own.norms[D - 1] = kernel.norm(D);
      own.force_norms[D - 1] = sphk::norm_of_forces(kernel, D);
    }
    return own;
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION Shape<T> operator()(T q) const {
    return lane_by_lane_of(shape, q);
  }
  template <class T>
  KOKKOS_INLINE_FUNCTION Shape<T> with_own_derivative(T q) const {
    return lane_by_lane_of(shape_of_slope, q);
  }
  template <class T>
  KOKKOS_INLINE_FUNCTION T w(T q) const {
    return (*this)(q).w;
  }
  KOKKOS_INLINE_FUNCTION double norm(int dimension) const { return norms[dimension - 1]; }
  KOKKOS_INLINE_FUNCTION double norm_of_forces(int dimension) const { return force_norms[dimension - 1]; }

 private:
  template <class T>
  KOKKOS_INLINE_FUNCTION static Shape<T> lane_by_lane_of(Shape<double> (*f)(double), T q) {
    using R = lane_t<T>;
    constexpr int L = lanes<T>;
    R x[L], w[L], dw[L];
    store(x, q);
    for (int lane = 0; lane < L; ++lane) {
      const Shape<double> one = f(static_cast<double>(x[lane]));
      w[lane] = static_cast<R>(one.w);
      dw[lane] = static_cast<R>(one.dw);
    }
    return {load<T>(w), load<T>(dw)};
  }
};

/// Those that modules have brought (src/schemes/modules.hpp).
inline std::vector<OwnKernel>& own_kernels() {
  static std::vector<OwnKernel> all;
  return all;
}

}  // namespace sphk
