// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/free_functions.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

// Pseudo-coherent OSPH (R10 footnote 4): eta = phi = zeta, with the terms of grad-h. With y_i = rho_i/eta_i = sum_j
// (m_j/eta_j) W(r_ij, h_i) and h bound by n, dy_i = sum_j (m_j/eta_j + z_i) dW(r_ij, h_i) at constant h, where z =
// -(h/(D n)) dy/dh / (1 + (h/(D n)) dn/dh). The force is the gradient of the thermal energy at constant eta and m.

/// a_i = - sum_j [P_i eta_i/rho_i^2 (m_j/eta_j + z_i) grad W(h_i) + (m_j/m_i) P_j eta_j/rho_j^2 (m_i/eta_i + z_j)
/// grad W(h_j)].
template <class FreePhi>
struct PressureGradientCoherent : PlainTerm {
  using Phi = FreePhi;
  static constexpr const char* label = "Pressure";
  static constexpr const char* name = "pressure gradient, pseudo-coherent with grad-h (R10 footnote 4)";
  using PlainTerm::PlainTerm;
  using Reads = List<Position, InverseSupport, Mass, ZetaPressure, InverseEta, GradHMass>;
  using Adds = List<Acceleration>;
  using Antisymmetric = List<Acceleration>;
  static constexpr int flops = 21;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(i.m)>;
    const P m_i_inv = P(lane_t<P>(1)) / i.m;
    sum.a -= (i.P_zeta * (j.m * j.eta_inv + i.z)) * ij.grad_W_i;
    sum.a -= (m_i_inv * j.m * j.P_zeta * (i.m * i.eta_inv + j.z)) * ij.grad_W_j;
  }
};

/// du_i/dt = P_i eta_i/rho_i^2 sum_j (m_j/eta_j + z_i) v_ij . grad W(h_i): the heat that this force pays for.
struct PressureWorkCoherent : PlainTerm {
  static constexpr const char* label = "PressureWork";
  static constexpr const char* name = "pressure work, pseudo-coherent with grad-h (R10 footnote 4)";
  using PlainTerm::PlainTerm;
  using Reads = List<Position, InverseSupport, Mass, Velocity, ZetaPressure, InverseEta, GradHMass>;
  using Adds = List<Heating>;
  static constexpr int flops = 13;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    sum.du = sum.du + i.P_zeta * (j.m * j.eta_inv + i.z) * dot(i.v - j.v, ij.grad_W_i);
  }
};

}  // namespace sphk
