// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/free_functions.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

/// Pressure force of standard SPH, R10 eq 10 with phi = 1: dv_i/dt = - sum_j m_j (P_i/rho_i^2 + P_j/rho_j^2) grad Wbar.
struct PressureGradientSph : PlainTerm {
  using Phi = One;
  static constexpr const char* label = "Pressure";
  static constexpr const char* name = "pressure gradient, P_i/rho_i^2 + P_j/rho_j^2 (R10 eq 10)";
  using PlainTerm::PlainTerm;
  using Reads = List<Position, InverseSupport, Mass, PressureOverDensity2>;
  using Adds = List<Acceleration>;
  using Antisymmetric = List<Acceleration>;
  static constexpr int flops = 8;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    sum.a -= (j.m * (i.P_rho2 + j.P_rho2)) * ij.grad_W;
  }
};

}  // namespace sphk
