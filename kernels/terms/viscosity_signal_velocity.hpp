// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/pair_limiter.hpp"
#include "kernels/terms/viscous_pair.hpp"

namespace sphk {

/// Signal-velocity viscosity (Monaghan 1997; S12 eq 29-31 with a constant alpha) with the Balsara factor, as in
/// GADGET-2: Pi_ij = -(alpha/2) v_sig w_ij / rho_ij for approaching pairs, v_sig = c_i + c_j - 3 w_ij.
template <class Limiter = BalsaraLimited>
struct ViscositySignalVelocity : Limiter {
  static constexpr const char* label = "Viscosity";
  static constexpr const char* name =
      "viscosity, signal velocity with the Balsara switch (S12 eq 29-31, constant alpha)";
  using Reads = Union<List<Position, InverseSupport, Mass, Velocity, Density, SoundSpeed>, typename Limiter::Reads>;
  using Adds = List<Acceleration, Heating>;
  using Antisymmetric = List<Acceleration>;
  using Numbers = sphk::Numbers<viscosity_alpha, viscosity_balsara>;
  static constexpr int flops = 32;
  double alpha;
  explicit ViscositySignalVelocity(const Given& given) : alpha(given[viscosity_alpha]) {}
  static bool idle(const Given& given, const GasTraits&) { return given[viscosity_alpha] == 0; }
  static double stiffness(const Given& given) { return given[viscosity_alpha]; }

  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(i.m)>;
    using T = lane_t<P>;
    const P w = sphk::min(dot(i.v - j.v, ij.r_ij) * ij.r_inv, P(T(0)));
    const P v_sig = i.c + j.c - P(T(3)) * w;
    // alpha/2 times the mean Balsara factor over the mean density: the two means' halves cancel.
    const P Pi = P(T(-0.5 * alpha)) * v_sig * w * Limiter::sum(i, j) / (i.rho + j.rho);
    detail::add_viscous_pair(sum, i, j, ij, Pi);
  }
};

}  // namespace sphk
