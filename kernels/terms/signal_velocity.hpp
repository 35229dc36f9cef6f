// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

/// v_max,i = max over pairs with r < max(h_i, h_j) of c_i + c_j - 3 w_ij (S12 eq 43), w_ij = v_ij . e_ij. The self pair
/// gives 2 c_i, so that it stays positive for receding or lonely particles.
struct SignalVelocity : PlainTerm {
  static constexpr const char* name = "largest signal velocity (S12 eq 43)";
  using PlainTerm::PlainTerm;
  using Reads = List<Position, InverseSupport, Velocity, SoundSpeed>;
  using Adds = List<MaxSignalVelocity>;
  static constexpr int flops = 13;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(i.c)>;
    using T = lane_t<P>;
    const P v_sig = i.c + j.c - P(T(3)) * dot(i.v - j.v, ij.r_ij) * ij.r_inv;
    sum.v_sig = sphk::max(sum.v_sig, select(ij.q_min < P(T(1)), v_sig, P(T(0))));
  }
};

}  // namespace sphk
