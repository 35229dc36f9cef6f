// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

inline constexpr Number conductivity_alpha{.key = "conductivity.alpha",
                                           .standard = 1,
                                           .meaning = "alpha_u, strength of artificial conductivity (V10 eq 2)",
                                           .max = 100};
inline constexpr Number conductivity_signal{
    .key = "conductivity.signal",
    .standard = 0,
    .meaning = "its signal velocity: Price 2008, or V10's with the sign of dP du (v1), of smoothed pressures (v2)",
    .max = 2,
    .words = "price|v1|v2"};

namespace detail {
/// alpha_u (m_j/rho_ij) v_sig^u (u_i - u_j) Wbar' with v_sig^u = sqrt(|dP|/rho_ij), times sign(dP du) where `signs` is
/// 1 and not where it is 0 (V10 eq 2-6); (gamma - 1) (u_i - u_j) is taken from the pressures.
KOKKOS_FORCEINLINE_FUNCTION auto conducted_heat(double alpha, double signs, const auto& dP, const auto& i,
                                                const auto& j, const auto& ij) {
  using P = std::remove_cvref_t<decltype(i.m)>;
  using T = lane_t<P>;
  const P rho_inv = P(T(2)) * i.rho_inv * j.rho_inv / (i.rho_inv + j.rho_inv);
  const P du = i.P * i.rho_inv - j.P * j.rho_inv;
  const P sign = select(dP * du < P(T(0)), P(T(1 - 2 * signs)), P(T(1)));
  return P(T(alpha)) * j.m * rho_inv * sign * sphk::sqrt(sphk::abs(dP) * rho_inv) * du * ij.dW;
}
}  // namespace detail

/// Artificial conductivity (Price 2008; V10 eq 2-5), du_i/dt = sum_j (m_j/rho_ij) alpha_u v_sig^u (u_i - u_j) Wbar',
/// with Price's v_sig^u = sqrt(|P_i - P_j|/rho_ij), or V10's first, which takes heat from the side of higher pressure.
struct ArtificialConductivity {
  static constexpr const char* label = "Conductivity";
  static constexpr const char* name = "artificial conductivity (Price 2008; V10 eq 2-5)";
  using Reads = List<Position, InverseSupport, Mass, Pressure, InverseDensity>;
  using Adds = List<Heating>;
  using Antisymmetric = List<Heating>;
  static constexpr int flops = 26;
  using Numbers = sphk::Numbers<conductivity_alpha, conductivity_signal>;
  double alpha, signs;  ///< alpha: alpha_u / (gamma - 1)
  explicit ArtificialConductivity(const Given& given)
      : alpha(given[conductivity_alpha] / (given[adiabatic_index] - 1)), signs(given[conductivity_signal]) {}
  static bool idle(const Given& given, const GasTraits&) { return given[conductivity_alpha] == 0; }
  static double stiffness(const Given& given) { return given[conductivity_alpha]; }
  static bool serves(const Given& given) { return given[conductivity_signal] < 2; }

  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    sum.du = sum.du + detail::conducted_heat(alpha, signs, i.P - j.P, i, j, ij);
  }
};

/// The same with V10's second signal velocity, of the smoothed pressures (V10 eq 6-7).
struct ArtificialConductivitySmoothed {
  static constexpr const char* label = "Conductivity";
  static constexpr const char* name = "artificial conductivity of smoothed pressures (V10 eq 2, 6, 7)";
  using Reads = List<Position, InverseSupport, Mass, Pressure, SmoothedPressure, InverseDensity>;
  using Adds = List<Heating>;
  using Antisymmetric = List<Heating>;
  static constexpr int flops = 26;
  using Numbers = sphk::Numbers<conductivity_alpha, conductivity_signal>;
  double alpha;
  explicit ArtificialConductivitySmoothed(const Given& given)
      : alpha(given[conductivity_alpha] / (given[adiabatic_index] - 1)) {}
  static bool idle(const Given& given, const GasTraits&) { return given[conductivity_alpha] == 0; }
  static double stiffness(const Given& given) { return given[conductivity_alpha]; }
  static bool serves(const Given& given) { return given[conductivity_signal] == 2; }

  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    sum.du = sum.du + detail::conducted_heat(alpha, 1, i.P_smooth - j.P_smooth, i, j, ij);
  }
};

}  // namespace sphk
