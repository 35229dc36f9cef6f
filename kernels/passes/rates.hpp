// SPDX-License-Identifier: BSD-3-Clause
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

  /// What j adds to i's sums.
  template <class P>
  KOKKOS_FORCEINLINE_FUNCTION void visit(Values<P, D, Adds>& sums, const auto& i, const auto& j) const {
    terms(sums, i, j, pair_of<mode, P, D>(state.smoothing, i, j));
  }

  KOKKOS_INLINE_FUNCTION void serve(const typename Base::Walk& walk, int i) const {
    const auto target = walk.target(i);
    Sums sums;
    set_zero(sums);
    walk.for_each(i, state.template at<Support>(i), [&](const auto& j) {
      Values<T, D, Adds> share;
      set_zero(share);
      visit(share, target, j);
      accumulate(sums, share);
    });
    out.store(i, sums);
  }

  void serve(Cell& cell) const {
    Sums sums[cell_size];
    Values<Pack, D, Adds> packs[sub_cell_size];
    const int begin = cell.begin();
    for_each_of(cell.targets(), 0, [&](int k) { set_zero(sums[k]); });
    cell.for_each_target(
        Base::lists_pay(),
        [&](int i, const auto& tile, int from, int to) { add(cell, i, tile, from, to, packs[i % sub_cell_size]); },
        [&](int i) { accumulate(sums[i - begin], packs[i % sub_cell_size]); });
    for_each_of(cell.targets(), begin, [&](int i) { out.store(i, sums[i - begin]); });
  }
  void add(const Cell& cell, int i, const auto& tile, int from, int to, Values<Pack, D, Adds>& packs) const {
    const auto target = Base::target_of(cell, i);
    Values<Pack, D, Adds> sums;
    if (from == 0)
      set_zero(sums);
    else
      sums = packs;
    Cell::for_each_pack(tile, from, to, target, [&](const auto& j) SPHK_ALWAYS_INLINE { visit(sums, target, j); });
    packs = sums;
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
