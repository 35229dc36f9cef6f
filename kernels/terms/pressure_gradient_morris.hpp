#pragma once

#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

/// Pressure force with the E0 error subtracted (Morris 1996; S12 eq 18, suffix e): dv_i/dt = - sum_j m_j (P_j -
/// P_i)/(rho_i rho_j) grad Wbar. Pairs do not conserve momentum.
struct PressureGradientMorris : PlainTerm {
  static constexpr const char* label = "Pressure";
  static constexpr const char* name = "pressure gradient, (P_j - P_i)/(rho_i rho_j) (Morris 1996, S12 eq 18)";
  using PlainTerm::PlainTerm;
  using Reads = List<Position, InverseSupport, Mass, Pressure, InverseDensity>;
  using Adds = List<Acceleration>;
  static constexpr int flops = 10;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    sum.a -= (j.m * (j.P - i.P) * i.rho_inv * j.rho_inv) * ij.grad_W;
  }
};

}  // namespace sphk
