#pragma once

#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/free_functions.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

/// Pressure force of TSPH, OSPH and SPHS, S12 eq 7: dv_i/dt = - sum_j m_j (P_i + P_j)/(rho_i rho_j) grad Wbar; or with
/// its E0 error subtracted, P_j - P_i in place of P_i + P_j (Morris 1996; S12 eq 18, suffix e), which does not conserve
/// the momentum of pairs.
struct PressureGradientTsph {
  using Phi = DensityItself;
  static constexpr const char* label = "Pressure";
  static constexpr const char* name = "pressure gradient, (P_j + P_i)/(rho_i rho_j), or P_j - P_i (S12 eq 7, 18)";
  using Reads = List<Position, InverseSupport, Mass, Pressure, InverseDensity>;
  using Adds = List<Acceleration>;
  static constexpr int flops = 10;
  double own;  ///< 1, or -1 where E0 is subtracted
  explicit PressureGradientTsph(const Parameters& p) : own(p.subtract_E0 ? -1 : 1) {}

  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(i.m)>;
    sum.a -= (j.m * (P(lane_t<P>(own)) * i.P + j.P) * i.rho_inv * j.rho_inv) * ij.grad_W;
  }
};

}  // namespace sphk
