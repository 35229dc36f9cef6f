// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/pair_limiter.hpp"
#include "kernels/terms/viscous_pair.hpp"

namespace sphk {

/// V10's viscosity as printed (eq 2): Pi_ij = - alpha v_sig w_ij / rho_ij for approaching pairs, v_sig = c_i + c_j -
/// beta w_ij with beta = 3/2. Its part by the speed of sound is twice GADGET-2's. Balsara's switch limits it, as it
/// does in the code that V10 used: without it no layer rolls up.
template <class Limiter = BalsaraLimited>
struct ViscosityValcke : Limiter {
  static constexpr const char* label = "Viscosity";
  static constexpr const char* name = "viscosity, signal velocity as printed in V10 eq 2";
  using Reads =
      Union<List<Position, InverseSupport, Mass, Velocity, InverseDensity, SoundSpeed>, typename Limiter::Reads>;
  using Adds = List<Acceleration, Heating>;
  using Antisymmetric = List<Acceleration>;
  static constexpr Number signal_beta{
      .key = "viscosity.beta", .standard = 1.5, .meaning = "beta of v_sig = c_i + c_j - beta w (V10 eq 2)", .max = 100};
  using Numbers = sphk::Numbers<viscosity_alpha, signal_beta, viscosity_balsara>;
  static constexpr int flops = 33;
  double alpha, beta;
  explicit ViscosityValcke(const Given& given) : alpha(given[viscosity_alpha]), beta(given[signal_beta]) {}
  static bool idle(const Given& given, const GasTraits&) { return given[viscosity_alpha] == 0; }
  /// Beyond the 3 of the signal velocity that steps follow, beta counts as well.
  static double stiffness(const Given& given) {
    return given[viscosity_alpha] * (given[signal_beta] > 3 ? given[signal_beta] / 3 : 1);
  }

  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(i.m)>;
    using T = lane_t<P>;
    const P w = sphk::min(dot(i.v - j.v, ij.r_ij) * ij.r_inv, P(T(0)));
    const P v_sig = i.c + j.c - P(T(beta)) * w;
    // Half the sum of Balsara's factors over half the sum of the densities.
    const P rho_sum_inv = i.rho_inv * j.rho_inv / (i.rho_inv + j.rho_inv);
    const P Pi = P(T(-alpha)) * v_sig * w * Limiter::sum(i, j) * rho_sum_inv;
    detail::add_viscous_pair(sum, i, j, ij, Pi);
  }
};

}  // namespace sphk
