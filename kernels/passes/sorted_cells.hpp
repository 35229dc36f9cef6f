// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/step_passes.hpp"

namespace sphk {

namespace detail {

template <int D>
bool strayed(const Domain<D>& domain, const Bounds<D>& all) {
  for (int d = 0; d < D; ++d) {
    const double period = domain.period[d], middle = domain.lower[d] + 0.5 * period;
    if (period > 0 && !(all.lo[d] > middle - period && all.hi[d] < middle + period)) return true;
  }
  return false;
}

template <class L>
struct PullToCentre {
  Particles<L> state;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    if (!state.active.contains(i)) return;
    const auto x = state.position(i);
    const double rate2 = state.central.rate2(x);
    for (int d = 0; d < L::dimension; ++d) state.template at<Acceleration>(i, d) -= rate2 * x[d];
  }
};

struct FillRow {
  double* row;
  double value;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const { row[i] = value; }
};

}  // namespace detail

template <class L>
void pull_to_centre(const Particles<L>& state) {
  Kokkos::parallel_for("central mass", Kokkos::RangePolicy<ExecutionSpace>(0, state.n), detail::PullToCentre<L>{state});
}

template <class L>
void fill_row(const Particles<L>& state, int row, double value) {
  double* first = state.columns.data.data() + static_cast<std::size_t>(row) * state.columns.stride;
  Kokkos::parallel_for("fill", Kokkos::RangePolicy<ExecutionSpace>(0, state.n), detail::FillRow{first, value});
}

template <class L>
void fit_cells(const Particles<L>& state, const ParticleSubset& cells) {
  fit(state.tree, state.columns, cells);
}

template <class L>
bool is_sort_due(const Particles<L>& state, const Schedule& schedule, long step) {
  const bool due = state.clock.individual ? schedule.updates_since_sort > sort_interval * double(state.n)
                                          : step % sort_interval == 0;
  return due || detail::strayed(state.tree.domain, bounds_of_all(state.tree));
}

template <class L>
void sort_cells(Particles<L>& state, Sorter<L::dimension>& sorter, Schedule& schedule) {
  StepClock& clock = state.clock;
  sorter(state.columns.data, state.columns.stride, state.ids, state.tree.domain, bounds_of_all(state.tree));
  if (clock.individual) {
    sorter.permute(clock.begin.data());
    sorter.permute(clock.end.data());
    sorter.permute(clock.power.data());
    Kokkos::deep_copy(ExecutionSpace(), schedule.caps, StepClock::block_bits);  // they are in the sort's memory
    schedule.updates_since_sort = 0;
    fit_ranges(state, schedule);
  }
  fit_cells(state, {});
}

}  // namespace sphk
