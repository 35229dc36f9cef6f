// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/core/values.hpp"
#include "kernels/smoothing/shape.hpp"

namespace sphk {

/// A smoothing kernel in D dimensions with its norms: W(r, h) = N_D h^-D w(r/h), and that of grad W.
template <class Kernel, int D>
struct Smoothing {
  Kernel kernel;
  double norm, force_norm;
  explicit Smoothing(const Kernel& k) : kernel(k), norm(k.norm(D)), force_norm(norm_of_forces(k, D)) {}
};

template <int D, class P>
KOKKOS_FORCEINLINE_FUNCTION P power_of_dimension(const P& x) {
  if constexpr (D == 1)
    return x;
  else if constexpr (D == 2)
    return x * x;
  else
    return x * x * x;
}

/// A pair as the gather sums of particle i see it: W(r_ij, h_i) alone.
template <class P, int D>
struct GatherPair {
  Vec<P, D> r_ij;    ///< x_i - x_j
  P q;               ///< r / h_i
  P W;               ///< W(r, h_i)
  P dW_dh;           ///< dW/dh_i at fixed r, by the kernel's own derivative
  Vec<P, D> grad_W;  ///< grad_i W(r, h_i)
};

namespace detail {
/// 1/r, finite for coincident particles, so that e_ij = r_ij / r = 0 there.
template <class P>
KOKKOS_FORCEINLINE_FUNCTION P inverse_length(const P& r) {
  using T = lane_t<P>;
  return P(T(1)) / sphk::max(r, P(T(1e-18)));
}
/// N_D h^-D of grad W: that of W, `scale`, but for kernels that say otherwise.
template <class P, int D, class Kernel>
KOKKOS_FORCEINLINE_FUNCTION P force_scale(const Smoothing<Kernel, D>& smoothing, const P& scale, const P& h_inv_D) {
  if constexpr (requires { smoothing.kernel.norm_of_forces(D); })
    return P(lane_t<P>(smoothing.force_norm)) * h_inv_D;
  else
    return scale;
}
}  // namespace detail

/// j holds the separation from i beside its own values.
template <class P, int D, class Kernel>
KOKKOS_FORCEINLINE_FUNCTION GatherPair<P, D> gather_pair(const Smoothing<Kernel, D>& smoothing, const auto& i,
                                                         const auto& j) {
  using T = lane_t<P>;
  GatherPair<P, D> ij;
  ij.r_ij = j.r_ij;
  const P r = sphk::sqrt(j.r2);
  ij.q = r * i.h_inv;
  const P h_inv_D = power_of_dimension<D>(i.h_inv), scale = P(T(smoothing.norm)) * h_inv_D;
  const Shape<P> shape = smoothing.kernel(ij.q);
  const Shape<P> own = with_own_derivative(smoothing.kernel, ij.q);
  ij.W = scale * shape.w;
  ij.dW_dh = -(scale * i.h_inv) * (P(T(D)) * own.w + ij.q * own.dw);
  ij.grad_W =
      (detail::force_scale(smoothing, scale, h_inv_D) * i.h_inv * shape.dw * detail::inverse_length(r)) * ij.r_ij;
  return ij;
}

/// A pair as the rates see it: the kernels of both sides and their mean.
template <class P, int D>
struct SymmetricPair {
  Vec<P, D> r_ij;      ///< x_i - x_j
  P r, r_inv;          ///< |r_ij| and its inverse
  P q;                 ///< r / h_i
  P q_min;             ///< r / max(h_i, h_j): the pair takes part where it is below 1
  Vec<P, D> grad_W_i;  ///< grad_i W(r, h_i)
  Vec<P, D> grad_W_j;  ///< grad_i W(r, h_j)
  P W;                 ///< Wbar = (W(r, h_i) + W(r, h_j)) / 2
  Vec<P, D> grad_W;    ///< grad_i Wbar
  P dW;                ///< e_ij . grad_i Wbar: dWbar/dr, zero for coincident particles
};

/// j holds the separation from i beside its own values.
template <class P, int D, class Kernel>
KOKKOS_FORCEINLINE_FUNCTION SymmetricPair<P, D> symmetric_pair(const Smoothing<Kernel, D>& smoothing, const auto& i,
                                                               const auto& j) {
  using T = lane_t<P>;
  SymmetricPair<P, D> ij;
  ij.r_ij = j.r_ij;
  ij.r = sphk::sqrt(j.r2);
  ij.r_inv = detail::inverse_length(ij.r);
  ij.q = ij.r * i.h_inv;
  ij.q_min = ij.r * sphk::min(i.h_inv, j.h_inv);
  const P norm = P(T(smoothing.norm));
  const P h_inv_D_i = power_of_dimension<D>(i.h_inv), h_inv_D_j = power_of_dimension<D>(j.h_inv);
  const P scale_i = norm * h_inv_D_i, scale_j = norm * h_inv_D_j;
  const Shape<P> shape_i = smoothing.kernel(ij.q), shape_j = smoothing.kernel(ij.r * j.h_inv);
  ij.W = P(T(0.5)) * (scale_i * shape_i.w + scale_j * shape_j.w);
  const P dW_i = detail::force_scale(smoothing, scale_i, h_inv_D_i) * i.h_inv * shape_i.dw * ij.r_inv;
  const P dW_j = detail::force_scale(smoothing, scale_j, h_inv_D_j) * j.h_inv * shape_j.dw * ij.r_inv;
  ij.grad_W_i = dW_i * ij.r_ij;
  ij.grad_W_j = dW_j * ij.r_ij;
  const P dW_r = P(T(0.5)) * (dW_i + dW_j);
  ij.grad_W = dW_r * ij.r_ij;
  ij.dW = dW_r * ij.r;
  return ij;
}

}  // namespace sphk
