// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

/// Compression work where u is integrated, R10 eq 18 with zeta = 1: du_i/dt = P_i/rho_i^2 sum_j m_j v_ij . grad Wbar.
struct PressureWork : PlainTerm {
  static constexpr const char* label = "PressureWork";
  static constexpr const char* name = "pressure work (R10 eq 18)";
  using PlainTerm::PlainTerm;
  using Reads = List<Position, InverseSupport, Mass, Velocity, PressureOverDensity2>;
  using Adds = List<Heating>;
  static constexpr int flops = 11;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    sum.du = sum.du + i.P_rho2 * j.m * dot(i.v - j.v, ij.grad_W);
  }
};

}  // namespace sphk
