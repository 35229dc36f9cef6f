// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>

namespace sphk {

/// The simulated volume on the device; `period` is 0 along an open axis.
template <int D>
struct Domain {
  double lower[D];
  double period[D];

  /// Moves x into [lower, lower + period) along periodic axis d.
  KOKKOS_INLINE_FUNCTION double wrapped(double x, int d) const {
    if (period[d] == 0) return x;
    const double inside = x - period[d] * Kokkos::floor((x - lower[d]) / period[d]);
    return inside < lower[d] + period[d] ? inside : lower[d];
  }
};

/// An axis-aligned box with the largest support radius of what is in it.
template <int D>
struct Bounds {
  double lo[D], hi[D];
  double h_max;

  KOKKOS_INLINE_FUNCTION static Bounds empty() {
    Bounds b;
    for (int d = 0; d < D; ++d) b.lo[d] = 1e300, b.hi[d] = -1e300;
    b.h_max = 0;
    return b;
  }
  KOKKOS_INLINE_FUNCTION void include(const Bounds& b) {
    for (int d = 0; d < D; ++d) {
      lo[d] = b.lo[d] < lo[d] ? b.lo[d] : lo[d];
      hi[d] = b.hi[d] > hi[d] ? b.hi[d] : hi[d];
    }
    h_max = b.h_max > h_max ? b.h_max : h_max;
  }
};

}  // namespace sphk
