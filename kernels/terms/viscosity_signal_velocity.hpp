#pragma once

#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/viscous_pair.hpp"

namespace sphk {

/// Signal-velocity viscosity (Monaghan 1997; S12 eq 29-31 with a constant alpha) with the Balsara factor, as in
/// GADGET-2: Pi_ij = -(alpha/2) v_sig w_ij / rho_ij for approaching pairs, v_sig = c_i + c_j - 3 w_ij.
struct ViscositySignalVelocity {
  static constexpr const char* label = "Viscosity";
  static constexpr const char* name =
      "viscosity, signal velocity with the Balsara switch (S12 eq 29-31, constant alpha)";
  using Reads = List<Position, InverseSupport, Mass, Velocity, Density, SoundSpeed, Balsara>;
  using Adds = List<Acceleration, Heating>;
  static constexpr int flops = 32;
  double alpha;
  explicit ViscositySignalVelocity(const Parameters& p) : alpha(p.alpha) {}

  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(i.m)>;
    using T = lane_t<P>;
    const P w = sphk::min(dot(i.v - j.v, ij.r_ij) * ij.r_inv, P(T(0)));
    const P v_sig = i.c + j.c - P(T(3)) * w;
    // alpha/2 times the mean Balsara factor over the mean density: the two means' halves cancel.
    const P Pi = P(T(-0.5 * alpha)) * v_sig * w * (i.balsara + j.balsara) / (i.rho + j.rho);
    detail::add_viscous_pair(sum, i, j, ij, Pi);
  }
};

}  // namespace sphk
