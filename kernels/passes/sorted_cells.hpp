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

}  // namespace detail

template <class L>
void fit_cells(const Particles<L>& state) {
  fit(state.tree, state.columns);
}

template <class L>
void sort_cells(Particles<L>& state, Sorter<L::dimension>& sorter, Schedule& schedule, long step) {
  fit_cells(state);
  const auto all = bounds_of_all(state.tree);
  StepClock& clock = state.clock;
  const bool due =
      clock.individual ? schedule.updates_since_sort > sort_interval * double(state.n) : step % sort_interval == 0;
  if (!due && !detail::strayed(state.tree.domain, all)) return;
  sorter(state.columns.data, state.columns.stride, state.ids, state.tree.domain, all);
  if (clock.individual) {
    sorter.permute(clock.begin, schedule.other);
    sorter.permute(clock.end, schedule.other);
    schedule.updates_since_sort = 0;
  }
  fit_cells(state);
}

}  // namespace sphk
