#pragma once

#include "kernels/passes/pair_loop.hpp"

namespace sphk {

namespace detail {

template <Reach mode>
using SupportOfBoth = std::conditional_t<mode == Reach::symmetric, List<InverseSupport>, List<>>;

template <Reach mode, class P, int D>
KOKKOS_FORCEINLINE_FUNCTION auto pair_of(const auto& smoothing, const auto& i, const auto& j) {
  if constexpr (mode == Reach::symmetric)
    return symmetric_pair<P, D>(smoothing, i, j);
  else
    return gather_pair<P, D>(smoothing, i, j);
}

/// The sums of Terms over the pairs of every active particle, one store a particle.
template <Reach mode, class S, class Terms, class Out>
struct PairSums : PairLoop<S, Union<SupportOfBoth<mode>, typename Terms::Reads>, mode> {
  using Base = PairLoop<S, Union<SupportOfBoth<mode>, typename Terms::Reads>, mode>;
  using Base::D;
  using Base::state;
  using typename Base::Cell;
  using typename Base::Pack;
  using typename Base::T;
  using Adds = typename Terms::Adds;
  using Sums = Values<double, D, Adds>;

  Terms terms;
  Out out;  ///< where the sums are stored

  PairSums(const State<S>& of, const Terms& t, const Out& o) : Base{of}, terms(t), out(o) {}

  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    if (!state.active.contains(i)) return;
    const typename Base::Walk walk{state.tree, state.columns};
    const auto values = walk.target(i);
    Sums sums;
    set_zero(sums);
    walk.for_each(i, state.template at<Support>(i), [&](const auto& j) {
      Values<T, D, Adds> pair_sums;
      set_zero(pair_sums);
      terms(pair_sums, values, j, pair_of<mode, T, D>(state.smoothing, values, j));
      accumulate(sums, pair_sums);
    });
    out.store(i, sums);
  }

  KOKKOS_INLINE_FUNCTION void operator()(const typename Base::Team& team) const {
    Base::for_targets_of(team, [&](Cell& cell) {
      Sums sums[cell_size];
      const int begin = cell.begin(), n = cell.end() - begin;
      for (int k = 0; k < n; ++k) set_zero(sums[k]);
      cell.for_each_target(root(state.tree), [&](int i) { add_sums(cell, i, sums[i - begin]); });
      for (int k = 0; k < n; ++k)
        if (cell.is_target(begin + k)) out.store(begin + k, sums[k]);
    });
  }

  void add_sums(Cell& cell, int i, Sums& sums) const {
    const auto values = Base::target_of(cell, i);
    cell.list(values.x, state.template at<Support>(i));
    const auto& neighbours = cell.neighbours();
    Values<Pack, D, Adds> packs;
    set_zero(packs);
    for (int k = 0; k < neighbours.count; k += Cell::width) {
      const auto j = neighbours.template load<Pack>(k);
      terms(packs, values, j, pair_of<mode, Pack, D>(state.smoothing, values, j));
    }
    accumulate(sums, packs);
  }
};

}  // namespace detail

/// The sums of all terms, stored in the columns `out`, which hold what the terms add: over pairs with r < max(h_i,
/// h_j), or with r < h_i for Reach::gather. The tree must be fitted to the present positions and supports.
template <Reach mode = Reach::symmetric, class Terms, class S, class Out>
void add_pair_sums(const char* name, const State<S>& state, const Terms& terms, const Out& out) {
  run_pairs(name, detail::PairSums<mode, S, Terms, Out>(state, terms, out));
}

}  // namespace sphk
