// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/terms/switched_pair.hpp"

namespace sphk {

/// How the momentum and energy of a particle follow the mass that it exchanges, as numbers: i gains G = gain max(F, 0)
/// + loss min(F, 0) of what F brings, `own` times its own velocity and energy (mass_exchange.hpp), and the work of
/// rho's change is paid for or not.
struct MassForm {
  double gain, loss, own;
  bool paid;
};
/// The words of dissipation.mass_form, in their order.
inline constexpr MassForm mass_forms[] = {
    {.gain = 1, .loss = 0, .own = 0, .paid = true},    // donor: mass brings the velocity and energy of its giver
    {.gain = 1, .loss = 0, .own = 0, .paid = false},   // the same without the work of rho's change
    {.gain = 1, .loss = 1, .own = 1, .paid = false},   // flux: S12 eq E6 and E8
    {.gain = 0, .loss = 0, .own = -1, .paid = false},  // every particle keeps its own (S12 eq 39-40)
};
inline constexpr Number mass_form{
    .key = "dissipation.mass_form",
    .standard = 0,
    .meaning = "what exchanged mass brings along: the donor's velocity and energy, App. E's flux, or nothing (S12)",
    .max = 3,
    .words = "donor|donor-unpaid|flux|particle"};
inline const MassForm& mass_form_of(const Given& given) {
  return mass_forms[static_cast<int>(given[mass_form])];
}

/// Mass dissipation of SPHS (S12 eq 36): i gains F_ij = alpha_m (m_ij/rho_ij) alpha_ij v_sig^p L_ij (m_i - m_j) Wbar'
/// from j, and dm_i/dt = sum_j F_ij. What the mass brings along is added against i's own state, so that a frame moving
/// with i is as good as any: with G = max(F, 0) (donor), F (flux form) or 0 (S12's per-particle form), sum_j G (v_j -
/// v_i) and sum_j G [u_j - u_i + v_ij^2/2]; MassExchange makes the rates of v and u of them.
struct MassDissipation : SwitchedAlpha {
  static constexpr const char* label = "MassDissipation";
  static constexpr const char* name = "mass dissipation (S12 eq 36)";
  using Reads = List<Position, InverseSupport, Mass, Velocity, Pressure, InverseDensity, SoundSpeed, DissipationAlpha>;
  using Adds = List<MassRate, MassMomentum, MassEnergy>;
  static constexpr Number alpha_m{.key = "dissipation.mass",
                                  .standard = 1,
                                  .meaning = "alpha_m, strength of mass dissipation, where masses differ (S12 eq 36)",
                                  .max = 100};
  using Numbers = sphk::Numbers<alpha_m, mass_form, switch_alpha>;
  static constexpr int flops = 44;
  double strength;     ///< alpha_m / 2: m_ij is half the sum
  double gain, loss;   ///< G = gain max(F, 0) + loss min(F, 0)
  double gamma_1_inv;  ///< 1 / (gamma - 1)
  explicit MassDissipation(const Given& given)
      : strength(0.5 * given[alpha_m]),
        gain(mass_form_of(given).gain),
        loss(mass_form_of(given).loss),
        gamma_1_inv(1 / (given[adiabatic_index] - 1)) {}
  static bool idle(const Given& given, const GasTraits& gas) { return gas.equal_masses || given[alpha_m] == 0; }
  static double stiffness(const Given& given) { return given[alpha_m] * largest_alpha(given); }

  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(i.m)>;
    using T = lane_t<P>;
    const P F =
        P(T(strength)) * (i.m * i.m - j.m * j.m) * detail::dissipation_strength(of_dissipation(i, j), i, j, ij) * ij.dW;
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
