// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/pair_limiter.hpp"
#include "kernels/terms/viscous_pair.hpp"

namespace sphk {

/// beta of Gingold & Monaghan's viscosity.
inline constexpr Number viscosity_beta{
    .key = "viscosity.beta", .standard = 2, .meaning = "beta, strength of the quadratic viscosity", .max = 100};

namespace detail {
/// mu_ij = hs v_ij . r_ij/(r^2 + 0.01 hs^2) of an approaching pair, else 0; hs is half the mean support radius (Gingold
/// & Monaghan 1983, GASOLINE's h).
KOKKOS_FORCEINLINE_FUNCTION auto approach_mu(const auto& i, const auto& j, const auto& ij) {
  using P = std::remove_cvref_t<decltype(i.h)>;
  using T = lane_t<P>;
  const P hs = P(T(0.25)) * (i.h + j.h);
  const P approach = sphk::min(dot(i.v - j.v, ij.r_ij), P(T(0)));
  return hs * approach / (ij.r * ij.r + P(T(0.01)) * hs * hs);
}
}  // namespace detail

/// Gingold & Monaghan's (1983) viscosity as in R10, with the Balsara switch: Pi_ij = (-alpha cbar mu + beta
/// mu^2)/rho_ij, mu = hs v_ij . r_ij/(r^2 + 0.01 hs^2) for approaching pairs, hs half the mean support radius.
template <class Limiter = BalsaraLimited>
struct ViscosityGingoldMonaghan : Limiter {
  static constexpr const char* label = "Viscosity";
  static constexpr const char* name = "viscosity, Gingold & Monaghan 1983 with the Balsara switch (R10)";
  using Reads = Union<List<Position, InverseSupport, Mass, Velocity, InverseDensity, SoundSpeed, Support>,
                      typename Limiter::Reads>;
  using Adds = List<Acceleration, Heating>;
  using Antisymmetric = List<Acceleration>;
  using Numbers = sphk::Numbers<viscosity_alpha, viscosity_beta, viscosity_balsara>;
  static constexpr int flops = 40;
  double alpha, beta;
  explicit ViscosityGingoldMonaghan(const Given& given) : alpha(given[viscosity_alpha]), beta(given[viscosity_beta]) {}
  static bool idle(const Given& given, const GasTraits&) {
    return given[viscosity_alpha] == 0 && given[viscosity_beta] == 0;
  }

  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(i.m)>;
    using T = lane_t<P>;
    const P mu = detail::approach_mu(i, j, ij);
    // 1 / (rho_i + rho_j), and the halves of cbar, rho_ij and the mean Balsara factor: (1/2 . 1/2) / (1/2), 1/2 /
    // (1/2).
    const P rho_sum_inv = i.rho_inv * j.rho_inv / (i.rho_inv + j.rho_inv);
    const P Pi = mu * (P(T(beta)) * mu - P(T(0.5 * alpha)) * (i.c + j.c)) * Limiter::sum(i, j) * rho_sum_inv;
    detail::add_viscous_pair(sum, i, j, ij, Pi);
  }
};

/// What limits the time-step of that viscosity (Monaghan 1992, R10's Courant condition): v_max,i = 2 [(1 + alpha) c_i +
/// beta max |mu_ij|], so that C h_i / v_max,i is C hs over the bracket. The self pair gives 2 (1 + alpha) c_i.
struct SignalVelocityMonaghan {
  static constexpr const char* name = "largest signal velocity, 2 ((1 + alpha) c + beta |mu|) (Monaghan 1992)";
  using Reads = List<Position, InverseSupport, Velocity, SoundSpeed, Support>;
  using Adds = List<MaxSignalVelocity>;
  using Numbers = sphk::Numbers<viscosity_alpha, viscosity_beta>;
  static constexpr int flops = 8;
  double alpha, beta;
  explicit SignalVelocityMonaghan(const Given& given) : alpha(given[viscosity_alpha]), beta(given[viscosity_beta]) {}

  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(i.c)>;
    using T = lane_t<P>;
    const P v_sig = P(T(2 * (1 + alpha))) * i.c - P(T(2 * beta)) * detail::approach_mu(i, j, ij);
    sum.v_sig = sphk::max(sum.v_sig, select(ij.q_min < P(T(1)), v_sig, P(T(0))));
  }
};

}  // namespace sphk
