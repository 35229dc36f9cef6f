#pragma once

#include "kernels/passes/pair_loop.hpp"

namespace sphk {

namespace detail {

template <class S, class Terms, class Out>
struct PairRates : PairLoop<S, Union<List<InverseSupport>, typename Terms::Reads>, Reach::symmetric> {
  using Base = PairLoop<S, Union<List<InverseSupport>, typename Terms::Reads>, Reach::symmetric>;
  using Base::D;
  using Base::state;
  using typename Base::Cell;
  using typename Base::Pack;
  using typename Base::T;
  using Adds = typename Terms::Adds;
  using Sums = Values<double, D, Adds>;

  Terms terms;
  Out out;  ///< where the sums are stored

  PairRates(const State<S>& of, const Terms& t, const Out& o) : Base{of}, terms(t), out(o) {}

  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    if (!state.active.contains(i)) return;
    const typename Base::Walk walk{state.tree, state.columns};
    const auto values = walk.target(i);
    Sums sums;
    set_zero(sums);
    walk.for_each(i, state.template at<Support>(i), [&](const auto& j) {
      Values<T, D, Adds> pair_sums;
      set_zero(pair_sums);
      terms(pair_sums, values, j, symmetric_pair<T, D>(state.smoothing, values, j));
      accumulate(sums, pair_sums);
    });
    out.store(i, sums);
  }

  KOKKOS_INLINE_FUNCTION void operator()(const typename Base::Team& team) const {
    Cell cell = Base::cell_of(team);
    Sums sums[cell_size];
    const int begin = cell.begin(), n = cell.end() - begin;
    for (int k = 0; k < n; ++k) set_zero(sums[k]);
    cell.collect(root(state.tree), cell.bounds().h_max, [&](bool) {
      for (int s = cell.first_sub_cell(); s < cell.last_sub_cell(); ++s) {
        if (!cell.has_targets(s)) continue;
        cell.select(s, cell.sub_bounds(s).h_max);
        const int from = s * sub_cell_size, to = min(from + sub_cell_size, state.n);
        for (int i = from; i < to; ++i)
          if (cell.is_target(i)) add_sums(cell, i, sums[i - begin]);
      }
    });
    for (int k = 0; k < n; ++k)
      if (cell.is_target(begin + k)) out.store(begin + k, sums[k]);
  }

  void add_sums(Cell& cell, int i, Sums& sums) const {
    const auto values = Base::target_of(cell, i);
    cell.list(values.x, state.template at<Support>(i));
    const auto& neighbours = cell.neighbours();
    Values<Pack, D, Adds> packs;
    set_zero(packs);
    for (int k = 0; k < neighbours.count; k += Cell::width) {
      const auto j = neighbours.template load<Pack>(k);
      terms(packs, values, j, symmetric_pair<Pack, D>(state.smoothing, values, j));
    }
    accumulate(sums, packs);
  }
};

}  // namespace detail

/// The sums of all terms over symmetric pairs, r < max(h_i, h_j), stored in the columns `out`, which hold what the
/// terms add. The tree must be fitted to the present positions and supports.
template <class Terms, class S, class Out>
void add_pair_rates(const State<S>& state, const Terms& terms, const Out& out) {
  run_pairs("rates", detail::PairRates<S, Terms, Out>(state, terms, out));
}

}  // namespace sphk
