// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

/// Neighbours with r < h_i, self included.
struct NeighbourCountSum : PlainTerm {
  using PlainTerm::PlainTerm;
  using Reads = List<Position>;
  using Adds = List<NeighbourCount>;
  static constexpr int flops = 2;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto&, const auto&, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(ij.q)>;
    using T = lane_t<P>;
    sum.count = sum.count + select(ij.q < P(T(1)), P(T(1)), P(T(0)));
  }
};

}  // namespace sphk
