// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/terms/switched_pair.hpp"

namespace sphk {

/// Entropy dissipation of SPHS (S12 eq 33-35), as heat: du_i/dt = alpha_A sum_j (m_j/rho_ij) alpha_ij v_sig^p L_ij (u_i
/// - u_j) Wbar'. Pairs exchange thermal energy alone.
template <class AlphaOf = SwitchedAlpha>
struct EntropyDissipation : AlphaOf {
  static constexpr const char* label = "EntropyDissipation";
  static constexpr const char* name = "entropy dissipation with the pressure limiter (S12 eq 33-35)";
  using Reads = Union<List<Position, InverseSupport, Mass, Velocity, Pressure, InverseDensity, SoundSpeed>,
                      typename AlphaOf::DissipationReads>;
  using Adds = List<Heating>;
  using Antisymmetric = List<Heating>;
  static constexpr Number alpha_A{.key = "dissipation.entropy",
                                  .standard = 1,
                                  .meaning = "alpha_A, strength of entropy dissipation (S12 eq 33)",
                                  .max = 100};
  using Numbers = sphk::Numbers<alpha_A, switch_alpha>;
  static constexpr int flops = 28;
  double strength;  ///< alpha_A / (gamma - 1)
  explicit EntropyDissipation(const Given& given)
      : AlphaOf(given), strength(given[alpha_A] / (given[adiabatic_index] - 1)) {}
  static bool idle(const Given& given, const GasTraits&) { return given[alpha_A] == 0; }
  static double stiffness(const Given& given) { return given[alpha_A] * largest_alpha(given); }

  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(i.m)>;
    const P rate =
        P(lane_t<P>(strength)) * j.m * detail::dissipation_strength(this->of_dissipation(i, j), i, j, ij) * ij.dW;
    sum.du = sum.du + rate * detail::energy_difference(i, j);
  }
};

}  // namespace sphk
