// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/core/simd.hpp"

namespace sphk {

/// Shape of a smoothing kernel at q = r/h: w(q) and dw/dq, without the norm. W(r, h) = N_D / h^D w(r/h) and
/// dW/dr = N_D / h^(D+1) dw(r/h); both vanish for q >= 1.
///
/// A smoothing kernel is a small value with `name`, `spacings` (the support radius in mean distances of particles that
/// is usual with it), `flops` (operations of one call of operator(): additions, products, min and max count 1, a fused
/// multiply-add 2), operator()(q) -> Shape, w(q) and norm(dimension) -> N_D.
/// q >= 0 is a float, a double or a SIMD pack; constants are made in lane_t<T>, so that floats never meet doubles.
template <class T>
struct Shape {
  static_assert(!std::is_integral_v<T>, "q is a float, a double or a pack of these: write 0.0, not 0");
  T w;
  T dw;
};

/// w with its own derivative, for dn/dh in the smoothing length and in grad-h. Only kernels whose operator() gives
/// another dw (HYDRA, the table) have a member of that name.
template <class Kernel, class T>
KOKKOS_FORCEINLINE_FUNCTION Shape<T> with_own_derivative(const Kernel& kernel, T q) {
  if constexpr (requires { kernel.with_own_derivative(q); })
    return kernel.with_own_derivative(q);
  else
    return kernel(q);
}

/// The norm of dw where it is another kernel's than w (members of that name): grad W has it.
template <class Kernel>
KOKKOS_INLINE_FUNCTION constexpr double norm_of_forces(const Kernel& kernel, int dimension) {
  if constexpr (requires { kernel.norm_of_forces(dimension); })
    return kernel.norm_of_forces(dimension);
  else
    return kernel.norm(dimension);
}

}  // namespace sphk
