#pragma once

#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/viscous_pair.hpp"

namespace sphk {

/// V10's viscosity as printed (eq 2): Pi_ij = - alpha v_sig w_ij / rho_ij for approaching pairs, v_sig = c_i + c_j -
/// beta w_ij with beta = 3/2. Its part by the speed of sound is twice GADGET-2's. Balsara's switch limits it, as it
/// does in the code that V10 used: without it no layer rolls up.
struct ViscosityValcke {
  static constexpr const char* label = "Viscosity";
  static constexpr const char* name = "viscosity, signal velocity as printed in V10 eq 2";
  using Reads = List<Position, InverseSupport, Mass, Velocity, InverseDensity, SoundSpeed, Balsara>;
  using Adds = List<Acceleration, Heating>;
  static constexpr int flops = 33;
  double alpha, beta;
  explicit ViscosityValcke(const Parameters& p) : alpha(p.alpha), beta(p.beta) {}

  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(i.m)>;
    using T = lane_t<P>;
    const P w = sphk::min(dot(i.v - j.v, ij.r_ij) * ij.r_inv, P(T(0)));
    const P v_sig = i.c + j.c - P(T(beta)) * w;
    // Half the sum of Balsara's factors over half the sum of the densities.
    const P rho_sum_inv = i.rho_inv * j.rho_inv / (i.rho_inv + j.rho_inv);
    const P Pi = P(T(-alpha)) * v_sig * w * (i.balsara + j.balsara) * rho_sum_inv;
    detail::add_viscous_pair(sum, i, j, ij, Pi);
  }
};

}  // namespace sphk
