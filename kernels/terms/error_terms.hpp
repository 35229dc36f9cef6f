// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

/// Leading errors of the generalised equations (R10 eq 28-30), g_ij = (rho_j/rho_i)(phi_i/phi_j), f_ij = (rho_j/rho_i)
/// (eta_i/eta_j):
///   E0_i =   sum_j (m_j/rho_j) [g_ij + 1/g_ij] h_i grad Wbar
///   R_i  = - sum_j (m_j/rho_j) f_ij S_ij
///   V_i  = - sum_j (m_j/rho_j) S_ij/g_ij,  S_ij = r Wbar' e_ij e_ij,
/// and what is left of the continuity equation where eta changes, from the particles' d ln(eta)/dt (R10 eq 21):
///   epsilon_i = sum_j m_j (d ln(eta_i)/dt - d ln(eta_j)/dt) (eta_i/eta_j) Wbar.
/// rho is the density of the equations of motion. Forces with grad-h are judged by the same sums, with their phi.
struct ErrorTerms : PlainTerm {
  using PlainTerm::PlainTerm;
  using Reads = List<Position, InverseSupport, Support, Mass, Density, InversePhi, InverseEta, EtaRate>;
  using Adds = List<ErrorE0, ErrorR, ErrorV, ErrorEpsilon>;
  static constexpr int flops = 66;

  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(i.m)>;
    const P one = lane_t<P>(1), V_j = j.m / j.rho;
    const P g = j.rho * j.phi_inv / (i.rho * i.phi_inv), f = j.rho * j.eta_inv / (i.rho * i.eta_inv);
    sum.E0 += (V_j * (g + one / g) * i.h) * ij.grad_W;
    add_matrix(sum.R, V_j * f, ij.grad_W, ij.r_ij);
    add_matrix(sum.V, V_j / g, ij.grad_W, ij.r_ij);
    sum.epsilon = sum.epsilon + j.m * (i.eta_rate - j.eta_rate) * (j.eta_inv / i.eta_inv) * ij.W;
  }

 private:
  /// - weight grad W r_ij, a symmetric matrix: the diagonal, then xy, xz, yz.
  template <class P, int D>
  KOKKOS_FORCEINLINE_FUNCTION static void add_matrix(Vec<P, symmetric_size<D>>& sum, const P& weight,
                                                     const Vec<P, D>& grad, const Vec<P, D>& r) {
    int k = D;
    for (int a = 0; a < D; ++a) {
      sum[a] = sum[a] - weight * grad[a] * r[a];
      for (int b = a + 1; b < D; ++b, ++k) sum[k] = sum[k] - weight * grad[a] * r[b];
    }
  }
};

/// How unlike and how near the neighbours are that lie within h_i. The contrast here is the ratio of the larger entropy
/// to the smaller; its logarithm is taken after the sum.
struct NeighbourhoodTerms : PlainTerm {
  using PlainTerm::PlainTerm;
  using Reads = List<Position, InverseSupport, Entropy>;
  using Adds = List<EntropyContrast, InverseNearest>;
  static constexpr int flops = 8;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(i.A)>;
    using T = lane_t<P>;
    const P zero = T(0);
    const P ratio = sphk::max(i.A, j.A) / sphk::max(sphk::min(i.A, j.A), P(Kokkos::Experimental::norm_min_v<T>));
    sum.contrast = sphk::max(sum.contrast, select(ij.q < P(T(1)), ratio, zero));
    sum.nearest_inv = sphk::max(sum.nearest_inv, select(ij.q < P(T(1)), select(zero < ij.r, ij.r_inv, zero), zero));
  }
};

}  // namespace sphk
