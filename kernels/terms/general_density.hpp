// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

/// rho_i/eta_i = sum_j (m_j/eta_j) W (R10 eq 19), W the pair's: Wbar, or W(r_ij, h_i) in a gather loop.
struct GeneralDensitySum : PlainTerm {
  using PlainTerm::PlainTerm;
  using Reads = List<Position, InverseSupport, Mass, InverseEta>;
  using Adds = List<GeneralDensity>;
  static constexpr int flops = 3;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto&, const auto& j, const auto& ij) const {
    sum.rho_eta = sum.rho_eta + j.m * j.eta_inv * ij.W;
  }
};

/// Its derivative in h_i, in a gather loop.
struct GeneralDensitySlopeSum : PlainTerm {
  using PlainTerm::PlainTerm;
  using Reads = List<Position, InverseSupport, Mass, InverseEta>;
  using Adds = List<GeneralDensitySlope>;
  static constexpr int flops = 3;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto&, const auto& j, const auto& ij) const {
    sum.slope_eta = sum.slope_eta + j.m * j.eta_inv * ij.dW_dh;
  }
};

/// sum_j m_j A_j rho_j^(gamma-1) Wbar (V10 eq 7): P_j/rho_j is what V10 sum.
struct SmoothedPressureSum : PlainTerm {
  using PlainTerm::PlainTerm;
  using Reads = List<Position, InverseSupport, Mass, Pressure, InverseDensity>;
  using Adds = List<SmoothedPressure>;
  static constexpr int flops = 4;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto&, const auto& j, const auto& ij) const {
    sum.P_smooth = sum.P_smooth + j.m * j.P * j.rho_inv * ij.W;
  }
};

}  // namespace sphk
