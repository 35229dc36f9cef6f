#pragma once

#include "kernels/cells/pair.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

namespace detail {
/// mu_ij = hs v_ij . r_ij/(r^2 + 0.01 hs^2) of an approaching pair, else 0; hs is half the mean support radius (Gingold &
/// Monaghan 1983, GASOLINE's h).
template <class P>
KOKKOS_FORCEINLINE_FUNCTION P approach_mu(const auto& i, const auto& j, const auto& ij, const P& r) {
  using T = lane_t<P>;
  const P hs = P(T(0.25)) * (i.h + j.h);
  const P approach = sphk::min(dot(i.v - j.v, ij.r_ij), P(T(0)));
  return hs * approach / (r * r + P(T(0.01)) * hs * hs);
}

/// dv_i/dt = - m_j Pi_ij grad Wbar and its heat du_i/dt = (1/2) m_j Pi_ij v_ij . grad Wbar: what i loses j's heat gains.
template <class P>
KOKKOS_FORCEINLINE_FUNCTION void add_viscous_pair(auto& sum, const auto& i, const auto& j, const auto& ij,
                                                  const P& Pi) {
  const P m_Pi = j.m * Pi;
  sum.a -= m_Pi * ij.grad_W;
  sum.du = sum.du + P(lane_t<P>(0.5)) * m_Pi * dot(i.v - j.v, ij.grad_W);
}
}  // namespace detail

/// Gingold & Monaghan's (1983) viscosity as in R10, with the Balsara switch: Pi_ij = (-alpha cbar mu + beta mu^2)/rho_ij,
/// mu = hs v_ij . r_ij/(r^2 + 0.01 hs^2) for approaching pairs, hs half the mean support radius.
struct ViscosityGingoldMonaghan {
  static constexpr const char* label = "Viscosity";
  static constexpr const char* name = "viscosity, Gingold & Monaghan 1983 with the Balsara switch (R10)";
  using Reads = List<Position, InverseSupport, Mass, Velocity, Density, SoundSpeed, Balsara, Support>;
  using Adds = List<Acceleration, Heating>;
  static constexpr int flops = 38;
  double alpha, beta;
  explicit ViscosityGingoldMonaghan(const Parameters& p) : alpha(p.alpha), beta(p.beta) {}

  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(i.m)>;
    using T = lane_t<P>;
    const P mu = detail::approach_mu(i, j, ij, ij.r);
    // The halves of cbar, rho_ij and the mean Balsara factor: (1/2 . 1/2) / (1/2) and 1/2 / (1/2).
    const P Pi = mu * (P(T(beta)) * mu - P(T(0.5 * alpha)) * (i.c + j.c)) * (i.balsara + j.balsara) / (i.rho + j.rho);
    detail::add_viscous_pair(sum, i, j, ij, Pi);
  }
};

/// What limits the time-step of that viscosity (Monaghan 1992, R10's Courant condition): v_max,i = 2 [(1 + alpha) c_i +
/// beta max |mu_ij|], so that C h_i / v_max,i is C hs over the bracket. The self pair gives 2 (1 + alpha) c_i.
struct SignalVelocityMonaghan {
  static constexpr const char* name = "largest signal velocity, 2 ((1 + alpha) c + beta |mu|) (Monaghan 1992)";
  using Reads = List<Position, InverseSupport, Velocity, SoundSpeed, Support>;
  using Adds = List<MaxSignalVelocity>;
  static constexpr int flops = 8;
  double alpha, beta;
  explicit SignalVelocityMonaghan(const Parameters& p) : alpha(p.alpha), beta(p.beta) {}

  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(i.c)>;
    using T = lane_t<P>;
    const P v_sig = P(T(2 * (1 + alpha))) * i.c - P(T(2 * beta)) * detail::approach_mu(i, j, ij, ij.r);
    sum.v_sig = sphk::max(sum.v_sig, select(ij.q_min < P(T(1)), v_sig, P(T(0))));
  }
};

/// Signal-velocity viscosity (Monaghan 1997; S12 eq 29-31 with a constant alpha) with the Balsara factor, as in GADGET-2:
/// Pi_ij = -(alpha/2) v_sig w_ij / rho_ij for approaching pairs, v_sig = c_i + c_j - 3 w_ij.
struct ViscositySignalVelocity {
  static constexpr const char* label = "Viscosity";
  static constexpr const char* name = "viscosity, signal velocity with the Balsara switch (S12 eq 29-31, constant alpha)";
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
