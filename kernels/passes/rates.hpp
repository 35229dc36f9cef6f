#pragma once

#include "kernels/cells/thread_walk.hpp"
#include "kernels/cells/tiled_cell.hpp"
#include "kernels/passes/state.hpp"

namespace sphk {

namespace detail {

template <class S, class Terms, class Out>
struct PairRates {
  static constexpr int D = S::dimension;
  using T = typename S::PairNumber;
  using Reads = Union<List<Position, InverseSupport>, typename Terms::Reads>;
  using Adds = typename Terms::Adds;
  using Columns = typename Particles<typename S::Layout>::Columns;
  using Cell = TiledCell<T, D, Reads, Reach::symmetric, Columns>;
  using Sums = Values<double, D, Adds>;
  using Policy = Kokkos::TeamPolicy<ExecutionSpace, Kokkos::Schedule<Kokkos::Dynamic>>;
  static constexpr int scratch_level = 1;

  State<S> state;
  Terms terms;
  Out out;  ///< where the sums are stored

  /// One thread per particle.
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    const ThreadWalk<T, D, Reads, Reach::symmetric, Columns> walk{state.tree, state.columns};
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

  /// A team of one host thread per cell, with tiles.
  KOKKOS_INLINE_FUNCTION void operator()(const typename Policy::member_type& team) const {
    Cell cell(team.team_scratch(scratch_level).get_shmem(Cell::scratch_bytes()), state.tree, state.columns,
              team.league_rank());
    Sums sums[cell_size];
    const int begin = cell.begin(), n = cell.end() - begin;
    for (int k = 0; k < n; ++k) set_zero(sums[k]);
    cell.collect(root(state.tree), cell.bounds().h_max, [&](bool) {
      for (int s = cell.first_sub_cell(); s < cell.last_sub_cell(); ++s) {
        cell.select(s, state.tree.node(0, s).h_max);
        const int from = s * sub_cell_size, to = min(from + sub_cell_size, state.n);
        for (int i = from; i < to; ++i) add_sums(cell, i, sums[i - begin]);
      }
    });
    for (int k = 0; k < n; ++k) out.store(begin + k, sums[k]);
  }

  KOKKOS_INLINE_FUNCTION void add_sums(const Cell& cell, int i, Sums& sums) const {
    using P = typename Cell::Pack;
    const auto values = load_relative<P, D>(Reads{}, state.columns, cell.frame(), i);
    Values<P, D, Adds> packs;
    set_zero(packs);
    const auto& tile = cell.candidates();
    for (int k = 0; k < tile.count; k += Cell::width) {
      const auto j = tile.template load<P>(k);
      terms(packs, values, j, symmetric_pair<P, D>(state.smoothing, values, j));
    }
    accumulate(sums, packs);
  }
};

}  // namespace detail

/// The sums of all terms over symmetric pairs, r < max(h_i, h_j), stored in the columns `out`, which hold what the
/// terms add. The tree must be fitted to the present positions and supports.
template <class Terms, class S, class Out>
void add_pair_rates(const State<S>& state, const Terms& terms, const Out& out) {
  using Rates = detail::PairRates<S, Terms, Out>;
  const Rates rates{state, terms, out};
  if (state.n == 0) return;
  if constexpr (tiles_pay) {
    auto policy = typename Rates::Policy(state.tree.cells(), 1)
                      .set_scratch_size(Rates::scratch_level, Kokkos::PerTeam(Rates::Cell::scratch_bytes()));
    Kokkos::parallel_for("rates", policy, rates);
  } else {
    Kokkos::parallel_for("rates", Kokkos::RangePolicy<ExecutionSpace>(0, state.n), rates);
  }
}

}  // namespace sphk
