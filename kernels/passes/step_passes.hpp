#pragma once

#include "kernels/passes/convergence_switch.hpp"
#include "kernels/passes/gradients.hpp"
#include "kernels/passes/mass_exchange.hpp"
#include "kernels/passes/rates.hpp"
#include "kernels/passes/run.hpp"
#include "kernels/passes/schedule.hpp"

namespace sphk {

/// Boxes of the cells; every ten steps (or as many updates), and when a particle strays half a period out of a periodic
/// box, the particles are sorted in space again and wrapped.
struct SortedCells {
  static constexpr const char* name = "cells";
  static constexpr int sort_interval = 10;
  using Writes = List<>;
  template <class S>
  static void run(Run<S>& run) {
    sort(run.state, run.sorter, run.schedule, run.step);
  }

 private:
  template <class L, class Sorter>
  static void sort(Particles<L>& state, Sorter& sorter, Schedule& schedule, long step) {
    fit(state.tree, state.columns);
    const auto all = bounds_of_all(state.tree);
    StepClock& clock = state.clock;
    const bool due = clock.individual ? schedule.updates_since_sort > sort_interval * double(state.n)
                                      : step % sort_interval == 0;
    if (!due && !strayed(state.tree.domain, all)) return;
    sorter(state.columns, state.ids, state.tree.domain, all);
    if (clock.individual) {
      sorter.permute(clock.begin, schedule.other);
      sorter.permute(clock.end, schedule.other);
      schedule.updates_since_sort = 0;
    }
    fit(state.tree, state.columns);
  }
  template <int D>
  static bool strayed(const Domain<D>& domain, const Bounds<D>& all) {
    for (int d = 0; d < D; ++d) {
      const double period = domain.period[d], middle = domain.lower[d] + 0.5 * period;
      if (period > 0 && !(all.lo[d] > middle - period && all.hi[d] < middle + period)) return true;
    }
    return false;
  }
};

/// Support radii and the gather sums; the cells learn the new radii.
struct SmoothingLength {
  static constexpr const char* name = "smoothing length and density";
  using Writes = List<>;
  template <class S>
  static void run(Run<S>& run) {
    run.searches = find_support(run.state, run.accept);
    fit(run.state.tree, run.state.columns);
  }
};

/// All terms in one loop over pairs.
struct Rates {
  static constexpr const char* name = "rates";
  using Writes = List<>;
  template <class S>
  static void run(Run<S>& run) {
    add_pair_sums(name, run.state, typename S::RateTerms(run.state.parameters), run.state.columns);
  }
};

}  // namespace sphk
