#pragma once

#include "kernels/terms/switched_pair.hpp"

namespace sphk {

/// Mass dissipation of SPHS (S12 eq 36): i gains F_ij = alpha_m (m_ij/rho_ij) alpha_ij v_sig^p L_ij (m_i - m_j) Wbar'
/// from j, and dm_i/dt = sum_j F_ij. What the mass brings along is added against i's own state, so that a frame moving
/// with i is as good as any: with G = max(F, 0) (donor), F (flux form) or 0 (S12's per-particle form), sum_j G (v_j -
/// v_i) and sum_j G [u_j - u_i + v_ij^2/2]; MassExchange makes the rates of v and u of them.
struct MassDissipation {
  static constexpr const char* label = "MassDissipation";
  static constexpr const char* name = "mass dissipation (S12 eq 36)";
  using Reads = List<Position, InverseSupport, Mass, Velocity, Pressure, InverseDensity, SoundSpeed, DissipationAlpha>;
  using Adds = List<MassRate, MassMomentum, MassEnergy>;
  static constexpr int flops = 44;
  double strength;     ///< alpha_m / 2: m_ij is half the sum
  double gain, loss;   ///< G = gain max(F, 0) + loss min(F, 0)
  double gamma_1_inv;  ///< 1 / (gamma - 1)
  explicit MassDissipation(const Parameters& p)
      : strength(0.5 * p.alpha_mass),
        gain(p.mass_correction == MassCorrection::particle ? 0 : 1),
        loss(p.mass_correction == MassCorrection::flux ? 1 : 0),
        gamma_1_inv(1 / (p.gamma - 1)) {}

  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(i.m)>;
    using T = lane_t<P>;
    const P F = P(T(strength)) * (i.m * i.m - j.m * j.m) * detail::dissipation_strength(i, j, ij) * ij.dW;
    const P G = P(T(gain)) * sphk::max(F, P(T(0))) + P(T(loss)) * sphk::min(F, P(T(0)));
    const auto v_ij = i.v - j.v;
    sum.dm = sum.dm + F;
    sum.dm_v -= G * v_ij;
    sum.dm_e = sum.dm_e + G * (P(T(0.5)) * dot(v_ij, v_ij) - P(T(gamma_1_inv)) * detail::energy_difference(i, j));
  }
};

/// sum_j (dm_j/dt) W(r_ij, h_i): rho sums masses, so an exchange of mass changes it.
struct MassDensityRateSum : PlainTerm {
  using PlainTerm::PlainTerm;
  using Reads = List<Position, MassRate>;
  using Adds = List<MassDensityRate>;
  static constexpr int flops = 2;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto&, const auto& j, const auto& ij) const {
    sum.dm_W = sum.dm_W + j.dm * ij.W;
  }
};

}  // namespace sphk
