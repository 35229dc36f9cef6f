// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

/// rho_i div v = - sum_j m_j v_ij . grad W(h_i): the standard SPH estimate; the division by rho_i comes after the sum.
struct VelocityDivergenceSum : PlainTerm {
  using PlainTerm::PlainTerm;
  using Reads = List<Position, Mass, Velocity>;
  using Adds = List<VelocityDivergence>;
  static constexpr int flops = 10;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    sum.div_v = sum.div_v - j.m * dot(i.v - j.v, ij.grad_W);
  }
};

/// rho_i curl v = sum_j m_j v_ij x grad W(h_i).
struct VelocityCurlSum : PlainTerm {
  using PlainTerm::PlainTerm;
  using Reads = List<Position, Mass, Velocity>;
  using Adds = List<VelocityCurl>;
  static constexpr int flops = 18;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    sum.curl_v += j.m * cross(i.v - j.v, ij.grad_W);
  }
};

}  // namespace sphk
