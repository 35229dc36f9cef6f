#pragma once

#include "kernels/cells/pair.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

/// Pressure force of standard SPH, R10 eq 10 with phi = 1: dv_i/dt = - sum_j m_j (P_i/rho_i^2 + P_j/rho_j^2) grad Wbar.
struct PressureGradientSph : PlainTerm {
  static constexpr const char* label = "Pressure";
  static constexpr const char* name = "pressure gradient, P_i/rho_i^2 + P_j/rho_j^2 (R10 eq 10)";
  using PlainTerm::PlainTerm;
  using Reads = List<Position, InverseSupport, Mass, PressureOverDensity2>;
  using Adds = List<Acceleration>;
  static constexpr int flops = 8;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    sum.a -= (j.m * (i.P_rho2 + j.P_rho2)) * ij.grad_W;
  }
};

/// Pressure force of TSPH, OSPH and SPHS, S12 eq 7: dv_i/dt = - sum_j m_j (P_i + P_j)/(rho_i rho_j) grad Wbar.
struct PressureGradientTsph : PlainTerm {
  static constexpr const char* label = "Pressure";
  static constexpr const char* name = "pressure gradient, (P_i + P_j)/(rho_i rho_j) (S12 eq 7)";
  using PlainTerm::PlainTerm;
  using Reads = List<Position, InverseSupport, Mass, Pressure, InverseDensity>;
  using Adds = List<Acceleration>;
  static constexpr int flops = 10;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    sum.a -= (j.m * (i.P + j.P) * i.rho_inv * j.rho_inv) * ij.grad_W;
  }
};

/// Conservative pressure force for any masses, the exact form where h follows the number density (S12 eq B1 for equal ones):
/// a_i = - sum_j [P_i/rho_i^2 (m_j + z_i) grad W(h_i) + (m_j/m_i) P_j/rho_j^2 (m_i + z_j) grad W(h_j)].
struct PressureGradientConservative : PlainTerm {
  static constexpr const char* label = "Pressure";
  static constexpr const char* name = "pressure gradient, conservative with grad-h (S12 eq B1, any masses)";
  using PlainTerm::PlainTerm;
  using Reads = List<Position, InverseSupport, Mass, PressureOverDensity2, GradHMass>;
  using Adds = List<Acceleration>;
  static constexpr int flops = 19;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(i.m)>;
    const P m_i_inv = P(lane_t<P>(1)) / i.m;
    sum.a -= (i.P_rho2 * (j.m + i.z)) * ij.grad_W_i;
    sum.a -= (m_i_inv * j.m * j.P_rho2 * (i.m + j.z)) * ij.grad_W_j;
  }
};

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
