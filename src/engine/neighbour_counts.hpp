// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/johnson.hpp"
#include "kernels/terms/neighbour_count.hpp"
#include "src/engine/scheme_interface.hpp"

namespace sphk::detail {

struct CountRange {
  double lowest = 1e300, highest = 0, sum = 0;
  KOKKOS_INLINE_FUNCTION CountRange& operator+=(const CountRange& b) {
    lowest = min(lowest, b.lowest);
    highest = max(highest, b.highest);
    sum += b.sum;
    return *this;
  }
};

template <class C>
struct RangeOfCounts {
  C columns;
  KOKKOS_INLINE_FUNCTION void operator()(int i, CountRange& range) const {
    const double count = columns.template at<NeighbourCount>(i);
    range += {count, count, count};
  }
};

/// A pair loop that needs no smoothing kernel; any serves.
template <class L>
struct Counting {
  static constexpr int dimension = L::dimension;
  using Layout = L;
  using Kernel = Johnson;
  using PairNumber = float;
};

}  // namespace sphk::detail

template <>
struct Kokkos::reduction_identity<sphk::detail::CountRange> {
  KOKKOS_FORCEINLINE_FUNCTION static sphk::detail::CountRange sum() { return {}; }
};

namespace sphk {

template <int D>
using CountColumns = Columns<D, List<NeighbourCount>>;

/// Minimum, mean and maximum of the true neighbours, r < h_i, self included, into the report; between two steps.
template <class L>
void count_neighbours(const Run<L>& run, StepReport& report) {
  const Particles<L>& particles = run.state;
  const CountColumns<L::dimension> counts(idle_row(run), particles.columns.stride);
  State<detail::Counting<L>> state{particles, Smoothing<Johnson, L::dimension>(Johnson{})};
  state.active = {};
  add_pair_sums("neighbour counts", state, TermSet<NeighbourCountSum>(Given{}), counts);
  detail::CountRange range;
  Kokkos::parallel_reduce("neighbour counts", Kokkos::RangePolicy<ExecutionSpace>(0, particles.n),
                          detail::RangeOfCounts<CountColumns<L::dimension>>{counts},
                          Kokkos::Sum<detail::CountRange>(range));
  report.min_neighbours = range.lowest;
  report.max_neighbours = range.highest;
  report.mean_neighbours = range.sum / particles.n;
}

}  // namespace sphk
