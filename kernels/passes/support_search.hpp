// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>

#include "kernels/core/simd.hpp"
#include "kernels/core/sphere.hpp"

namespace sphk {

/// Search for the support radius of one particle: the root of F(h) = V_D h^D n(h) - N_n (S12 eq 11), which grows with
/// h. Newton steps inside a bracket, bisection where they leave it; it always ends.
struct SupportSearch {
  enum class Result { search, found, capped, crowded, failed };
  static constexpr int max_evaluations = 100;

  double h;
  double below = 0;      ///< largest h known with F < 0
  double above = 1e300;  ///< smallest h known with F > 0
  int evaluations = 0;
  bool bisected = false;

  /// Takes n(h) and dn/dh; moves h to the next trial. `found` once the move is below accept * h: h is then the root to
  /// second order of the move, which is left in `move` for the caller to carry n over. `capped` at h_max with too few
  /// neighbours; `crowded` where coincident particles alone outnumber N_n, so that no h has fewer: h stays where it
  /// holds nobody else.
  template <int D>
  KOKKOS_INLINE_FUNCTION Result advance(double n, double dn_dh, double neighbours, double accept, double h_max,
                                        double& move) {
    const double volume = unit_sphere<D> * (D == 1 ? h : D == 2 ? h * h : h * h * h);
    const double F = volume * n - neighbours;
    const double dF = volume * (D * n / h + dn_dh);
    move = 0;
    ++evaluations;
    if (!(volume > 0 && F == F)) return Result::failed;
    if (F < 0 && h >= h_max) return Result::capped;
    if (F > 0 && dF * h < 1e-12 * neighbours) return Result::crowded;
    if (F > 0)
      above = sphk::min(above, h);
    else
      below = sphk::max(below, h);
    double next = dF > 0 ? h - F / dF : 2 * h;
    next = sphk::min(sphk::max(next, 0.5 * h), sphk::min(2 * h, h_max));
    if (Kokkos::abs(next - h) <= accept * h) {
      move = next - h;
      h = next;
      return Result::found;
    }
    if (evaluations >= max_evaluations) return Result::failed;
    if (!(next > below && next < above) && above < 1e300) {
      next = 0.5 * (below + above);
      bisected = true;
      if (next <= below || next >= above) return Result::found;
    }
    h = next;
    return Result::search;
  }
};

}  // namespace sphk
