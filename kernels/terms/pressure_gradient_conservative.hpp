// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/free_functions.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

/// Conservative pressure force for any masses, the exact form where h follows the number density (S12 eq B1 for equal
/// ones): a_i = - sum_j [P_i/rho_i^2 (m_j + z_i) grad W(h_i) + (m_j/m_i) P_j/rho_j^2 (m_i + z_j) grad W(h_j)].
struct PressureGradientConservative : PlainTerm {
  using Phi = One;
  static constexpr const char* label = "Pressure";
  static constexpr const char* name = "pressure gradient, conservative with grad-h (S12 eq B1, any masses)";
  using PlainTerm::PlainTerm;
  using Reads = List<Position, InverseSupport, Mass, PressureOverDensity2, GradHMass>;
  using Adds = List<Acceleration>;
  using Antisymmetric = List<Acceleration>;
  static constexpr int flops = 19;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(i.m)>;
    const P m_i_inv = P(lane_t<P>(1)) / i.m;
    sum.a -= (i.P_rho2 * (j.m + i.z)) * ij.grad_W_i;
    sum.a -= (m_i_inv * j.m * j.P_rho2 * (i.m + j.z)) * ij.grad_W_j;
  }
};

}  // namespace sphk
