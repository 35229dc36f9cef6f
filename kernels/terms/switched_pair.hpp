// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

/// alpha of every particle, in place of the convergence switch.
inline constexpr Number switch_alpha{.key = "switch.alpha",
                                     .standard = -1,
                                     .meaning = "alpha of all particles; negative: the switch decides (S12 App. C)",
                                     .min = -1,
                                     .max = 100};

/// The largest alpha that a particle can have.
inline double largest_alpha(const Given& given) {
  return given[switch_alpha] < 0 ? 1 : given[switch_alpha];
}

// Where the dissipation of a pair takes its alpha from: of_viscosity and of_dissipation are twice its mean.

/// The switch, with Balsara's factor.
struct SwitchedAlpha {
  using ViscosityReads = List<ViscosityAlpha>;
  using DissipationReads = List<DissipationAlpha>;
  SwitchedAlpha() = default;
  explicit SwitchedAlpha(const Given&) {}
  KOKKOS_FORCEINLINE_FUNCTION auto of_viscosity(const auto& i, const auto& j) const { return i.alpha_v + j.alpha_v; }
  KOKKOS_FORCEINLINE_FUNCTION auto of_dissipation(const auto& i, const auto& j) const { return i.alpha_d + j.alpha_d; }
};

/// One number for all.
struct ConstantAlpha {
  using ViscosityReads = List<>;
  using DissipationReads = List<>;
  double twice;
  explicit ConstantAlpha(const Given& given) : twice(2 * given[switch_alpha]) {}
  static bool serves(const Given& given) { return given[switch_alpha] >= 0; }
  KOKKOS_FORCEINLINE_FUNCTION auto of_viscosity(const auto& i, const auto&) const {
    using P = std::remove_cvref_t<decltype(i.m)>;
    return P(lane_t<P>(twice));
  }
  KOKKOS_FORCEINLINE_FUNCTION auto of_dissipation(const auto& i, const auto& j) const { return of_viscosity(i, j); }
};

namespace detail {

/// w_ij = v_ij . e_ij, negative for approaching pairs.
KOKKOS_FORCEINLINE_FUNCTION auto approach(const auto& i, const auto& j, const auto& ij) {
  return dot(i.v - j.v, ij.r_ij) * ij.r_inv;
}

/// 1 / (rho_i + rho_j), from the inverse densities.
KOKKOS_FORCEINLINE_FUNCTION auto inverse_density_sum(const auto& i, const auto& j) {
  return i.rho_inv * j.rho_inv / (i.rho_inv + j.rho_inv);
}

/// v_sig^p = max(0, c_i + c_j - 3 w_ij) (S12 eq 34).
KOKKOS_FORCEINLINE_FUNCTION auto positive_signal_velocity(const auto& i, const auto& j, const auto& ij) {
  using P = std::remove_cvref_t<decltype(i.c)>;
  using T = lane_t<P>;
  return sphk::max(i.c + j.c - P(T(3)) * approach(i, j, ij), P(T(0)));
}

/// alpha_ij v_sig^p L_ij / rho_ij of the dissipation of entropy and mass (S12 eq 33-36), L = |P_i-P_j|/(P_i+P_j); the
/// halves of the means of alpha and rho cancel.
KOKKOS_FORCEINLINE_FUNCTION auto dissipation_strength(const auto& alpha_sum, const auto& i, const auto& j,
                                                      const auto& ij) {
  using P = std::remove_cvref_t<decltype(i.P)>;
  using T = lane_t<P>;
  const P limiter = sphk::abs(i.P - j.P) / sphk::max(i.P + j.P, P(Kokkos::Experimental::norm_min_v<T>));
  return alpha_sum * positive_signal_velocity(i, j, ij) * limiter * inverse_density_sum(i, j);
}

/// (gamma - 1) (u_i - u_j), from the pressures.
KOKKOS_FORCEINLINE_FUNCTION auto energy_difference(const auto& i, const auto& j) {
  return i.P * i.rho_inv - j.P * j.rho_inv;
}

}  // namespace detail

}  // namespace sphk
