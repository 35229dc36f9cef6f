#pragma once

#include "kernels/terms/switched_pair.hpp"

namespace sphk {

/// Entropy dissipation of SPHS (S12 eq 33-35), as heat: du_i/dt = alpha_A sum_j (m_j/rho_ij) alpha_ij v_sig^p L_ij (u_i
/// - u_j) Wbar'. Pairs exchange thermal energy alone.
struct EntropyDissipation {
  static constexpr const char* label = "EntropyDissipation";
  static constexpr const char* name = "entropy dissipation with the pressure limiter (S12 eq 33-35)";
  using Reads = List<Position, InverseSupport, Mass, Velocity, Pressure, InverseDensity, SoundSpeed, DissipationAlpha>;
  using Adds = List<Heating>;
  static constexpr int flops = 28;
  double strength;  ///< alpha_A / (gamma - 1)
  explicit EntropyDissipation(const Parameters& p) : strength(p.alpha_entropy / (p.gamma - 1)) {}

  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(i.m)>;
    const P rate = P(lane_t<P>(strength)) * j.m * detail::dissipation_strength(i, j, ij) * ij.dW;
    sum.du = sum.du + rate * detail::energy_difference(i, j);
  }
};

}  // namespace sphk
