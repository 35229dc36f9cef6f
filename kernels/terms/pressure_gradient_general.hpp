// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/free_functions.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

/// Pressure force of the generalised family, R10 eq 17: dv_i/dt = - sum_j m_j [P_i/rho_i^2 phi_i/phi_j + P_j/rho_j^2
/// phi_j/phi_i] grad Wbar, written as (P_i phi_i^2/rho_i^2 + P_j phi_j^2/rho_j^2) / (phi_i phi_j).
template <class FreePhi>
struct PressureGradientGeneral : PlainTerm {
  using Phi = FreePhi;
  static constexpr const char* label = "Pressure";
  static constexpr const char* name = "pressure gradient with a free phi (R10 eq 17)";
  using PlainTerm::PlainTerm;
  using Reads = List<Position, InverseSupport, Mass, PhiPressure, InversePhi>;
  using Adds = List<Acceleration>;
  using Antisymmetric = List<Acceleration>;
  static constexpr int flops = 10;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    sum.a -= (j.m * (i.P_phi2 + j.P_phi2) * i.phi_inv * j.phi_inv) * ij.grad_W;
  }
};

/// Compression work of the family, R10 eq 18: du_i/dt = P_i/rho_i^2 sum_j m_j (zeta_i/zeta_j) v_ij . grad Wbar.
struct PressureWorkGeneral : PlainTerm {
  static constexpr const char* label = "PressureWork";
  static constexpr const char* name = "pressure work with a free zeta (R10 eq 18)";
  using PlainTerm::PlainTerm;
  using Reads = List<Position, InverseSupport, Mass, Velocity, ZetaPressure, InverseZeta>;
  using Adds = List<Heating>;
  static constexpr int flops = 12;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    sum.du = sum.du + i.P_zeta * j.m * j.zeta_inv * dot(i.v - j.v, ij.grad_W);
  }
};

}  // namespace sphk
