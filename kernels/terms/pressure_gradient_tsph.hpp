// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/free_functions.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

/// Pressure force of TSPH and SPHS, S12 eq 7: dv_i/dt = - sum_j m_j (P_i + P_j)/(rho_i rho_j) grad Wbar.
struct PressureGradientTsph : PlainTerm {
  using Phi = DensityItself;
  static constexpr const char* label = "Pressure";
  static constexpr const char* name = "pressure gradient, (P_i + P_j)/(rho_i rho_j) (S12 eq 7)";
  using PlainTerm::PlainTerm;
  using Reads = List<Position, InverseSupport, Mass, Pressure, InverseDensity>;
  using Adds = List<Acceleration>;
  using Antisymmetric = List<Acceleration>;
  static constexpr int flops = 10;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    sum.a -= (j.m * (i.P + j.P) * i.rho_inv * j.rho_inv) * ij.grad_W;
  }
};

/// The same with its E0 error subtracted, P_j - P_i in place of P_i + P_j (Morris 1996; S12 eq 18, suffix e), which
/// does not conserve the momentum of pairs.
struct PressureGradientMorris : PlainTerm {
  using Phi = DensityItself;
  static constexpr const char* label = "Pressure";
  static constexpr const char* name = "pressure gradient, (P_j - P_i)/(rho_i rho_j) (S12 eq 18)";
  using PlainTerm::PlainTerm;
  using Reads = List<Position, InverseSupport, Mass, Pressure, InverseDensity>;
  using Adds = List<Acceleration>;
  static constexpr int flops = 10;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    sum.a -= (j.m * (j.P - i.P) * i.rho_inv * j.rho_inv) * ij.grad_W;
  }
};

}  // namespace sphk
