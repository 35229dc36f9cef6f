// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

/// alpha of Gingold & Monaghan and of signal-velocity viscosities; alpha_v where a switch multiplies it (S12 eq 29).
inline constexpr Number viscosity_alpha{
    .key = "viscosity.alpha", .standard = 1, .meaning = "alpha, strength of the viscosity", .max = 100};

namespace detail {
/// dv_i/dt = - m_j Pi_ij grad Wbar and its heat du_i/dt = (1/2) m_j Pi_ij v_ij . grad Wbar: what i loses j's heat
/// gains.
template <class P>
KOKKOS_FORCEINLINE_FUNCTION void add_viscous_pair(auto& sum, const auto& i, const auto& j, const auto& ij,
                                                  const P& Pi) {
  const P m_Pi = j.m * Pi;
  sum.a -= m_Pi * ij.grad_W;
  sum.du = sum.du + P(lane_t<P>(0.5)) * m_Pi * dot(i.v - j.v, ij.grad_W);
}
}  // namespace detail

}  // namespace sphk
