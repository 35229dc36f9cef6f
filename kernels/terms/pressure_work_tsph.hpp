// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

/// Compression work where u is integrated, R10 eq 18 with zeta = phi = rho: du_i/dt = (P_i/rho_i) sum_j (m_j/rho_j)
/// v_ij . grad Wbar. What the pressure force of S12 eq 7 takes from the motion of a pair, this gives to its heat.
struct PressureWorkTsph : PlainTerm {
  static constexpr const char* label = "PressureWork";
  static constexpr const char* name = "pressure work (R10 eq 18 with zeta = rho)";
  using PlainTerm::PlainTerm;
  using Reads = List<Position, InverseSupport, Mass, Velocity, Pressure, InverseDensity>;
  using Adds = List<Heating>;
  static constexpr int flops = 12;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    sum.du = sum.du + i.P * i.rho_inv * j.m * j.rho_inv * dot(i.v - j.v, ij.grad_W);
  }
};

}  // namespace sphk
