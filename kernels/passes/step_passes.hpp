#pragma once

#include "kernels/passes/rates.hpp"
#include "kernels/passes/run.hpp"

namespace sphk {

/// Boxes of the cells; every ten steps the particles are sorted in space again.
struct SortedCells {
  static constexpr const char* name = "cells";
  static constexpr int sort_interval = 10;
  using Writes = List<>;
  template <class S>
  static void run(Run<S>& run) {
    auto& state = run.state;
    fit(state.tree, state.columns);
    if (run.step % sort_interval != 0) return;
    run.sorter(state.columns, state.ids, state.tree.domain, bounds_of_all(state.tree));
    fit(state.tree, state.columns);
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
    add_pair_rates(run.state, typename S::RateTerms(run.state.parameters), run.state.columns);
  }
};

}  // namespace sphk
