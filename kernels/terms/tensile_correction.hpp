// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/core/family_fields.hpp"
#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

/// 1/W(d_i, h_i) at the mean distance of particles, d_i = n_i^(-1/D).
struct InverseSpacingKernel {
  static constexpr FieldFacts facts{
      .name = "InverseSpacingKernels", .description = "1/W at the mean distance of particles", .unit = {.volume = 1}};
  template <class T, int D>
  struct Value {
    T W_d_inv;
  };
};

/// Artificial pressure against clumping (Monaghan 2000, eq 14-18; R10 sec 3.4.1 cures the same by the kernel's core),
/// in the form of TSPH's pressure force: dv_i/dt = - sum_j m_j R_ij f_ij^4 grad Wbar, R_ij = epsilon (P_i + P_j)/(rho_i
/// rho_j), f_ij = Wbar(r_ij)/W(d), d the mean distance of particles. It pushes apart what is nearer than that, and its
/// work is heat, so that energy stays.
struct TensileCorrection {
  static constexpr const char* label = "TensileCorrection";
  static constexpr const char* name = "tensile correction (Monaghan 2000)";
  using Reads = List<Position, InverseSupport, Mass, Velocity, Pressure, InverseDensity, InverseSpacingKernel>;
  using Adds = List<Acceleration, Heating>;
  using Antisymmetric = List<Acceleration>;
  static constexpr Number epsilon{.key = "tensile.epsilon",
                                  .standard = 0.2,
                                  .meaning = "strength of the pressure against clumping (Monaghan 2000)",
                                  .max = 10};
  using Numbers = sphk::Numbers<epsilon>;
  static constexpr int flops = 26;
  double half;  ///< epsilon / 2
  explicit TensileCorrection(const Given& given) : half(0.5 * given[epsilon]) {}
  static bool idle(const Given& given, const GasTraits&) { return given[epsilon] == 0; }

  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(i.m)>;
    using T = lane_t<P>;
    const P f = P(T(0.5)) * ij.W * (i.W_d_inv + j.W_d_inv), f2 = f * f;
    const P half_push = P(T(half)) * j.m * (i.P + j.P) * i.rho_inv * j.rho_inv * f2 * f2;
    sum.a -= (P(T(2)) * half_push) * ij.grad_W;
    sum.du = sum.du + half_push * dot(i.v - j.v, ij.grad_W);
  }
};

}  // namespace sphk
