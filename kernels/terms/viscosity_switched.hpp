// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/terms/switched_pair.hpp"
#include "kernels/terms/viscous_pair.hpp"

namespace sphk {

/// Viscosity of SPHS (S12 eq 29-31): Pi_ij = -(alpha_v/2) alpha_ij v_sig w_ij / rho_ij for approaching pairs, v_sig =
/// c_i + c_j - 3 w_ij, alpha_ij the mean of the switch with Balsara's factor.
template <class AlphaOf = SwitchedAlpha>
struct ViscositySwitched : AlphaOf {
  static constexpr const char* label = "Viscosity";
  static constexpr const char* name = "viscosity, switched (S12 eq 29-32)";
  using Reads = Union<List<Position, InverseSupport, Mass, Velocity, InverseDensity, SoundSpeed>,
                      typename AlphaOf::ViscosityReads>;
  using Adds = List<Acceleration, Heating>;
  using Antisymmetric = List<Acceleration>;
  using Numbers = sphk::Numbers<viscosity_alpha, switch_alpha>;
  static constexpr int flops = 34;
  double alpha;
  explicit ViscositySwitched(const Given& given) : AlphaOf(given), alpha(given[viscosity_alpha]) {}
  static bool idle(const Given& given, const GasTraits&) { return given[viscosity_alpha] == 0; }
  static double stiffness(const Given& given) { return given[viscosity_alpha] * largest_alpha(given); }

  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(i.m)>;
    using T = lane_t<P>;
    const P w = sphk::min(detail::approach(i, j, ij), P(T(0)));
    const P v_sig = i.c + j.c - P(T(3)) * w;
    // Half the sum of the alphas over half the sum of the densities.
    const P Pi = P(T(-0.5 * alpha)) * v_sig * w * this->of_viscosity(i, j) * detail::inverse_density_sum(i, j);
    detail::add_viscous_pair(sum, i, j, ij, Pi);
  }
};

}  // namespace sphk
