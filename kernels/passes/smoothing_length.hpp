#pragma once

#include "kernels/cells/thread_walk.hpp"
#include "kernels/cells/tiled_cell.hpp"
#include "kernels/passes/state.hpp"
#include "kernels/passes/support_search.hpp"
#include "kernels/terms/density.hpp"

namespace sphk {

/// How the searches of one pass went.
struct SupportCounts {
  long evaluations = 0;  ///< of n(h), over all particles
  long bisections = 0;   ///< particles that needed the safety net
  long capped = 0;       ///< particles that stay at h_max with too few neighbours
  long crowded = 0;      ///< coincident particles, more of them than neighbours asked
  long failed = 0;

  KOKKOS_INLINE_FUNCTION SupportCounts& operator+=(const SupportCounts& b) {
    evaluations += b.evaluations;
    bisections += b.bisections;
    capped += b.capped;
    crowded += b.crowded;
    failed += b.failed;
    return *this;
  }
  KOKKOS_INLINE_FUNCTION void count(const SupportSearch& search, SupportSearch::Result result) {
    evaluations += search.evaluations;
    bisections += search.bisected;
    capped += result == SupportSearch::Result::capped;
    crowded += result == SupportSearch::Result::crowded;
    failed += result == SupportSearch::Result::failed;
  }
};

namespace detail {

template <class S>
struct FindSupport {
  static constexpr int D = S::dimension;
  using T = typename S::PairNumber;
  using Terms = typename S::DensityTerms;
  using Reads = Union<List<Position>, typename Terms::Reads>;
  using Adds = typename Terms::Adds;
  using Columns = typename Particles<typename S::Layout>::Columns;
  using Cell = TiledCell<T, D, Reads, Reach::gather, Columns>;
  using Sums = Values<double, D, Adds>;
  using Result = SupportSearch::Result;
  using Policy = Kokkos::TeamPolicy<ExecutionSpace, Kokkos::Schedule<Kokkos::Dynamic>>;
  static constexpr int scratch_level = 1;

  State<S> state;
  Terms terms;
  double accept;

  /// Sums over the candidates of a tile for particle i at support h.
  KOKKOS_INLINE_FUNCTION void add_sums(const Cell& cell, int i, double h, Sums& sums) const {
    using P = typename Cell::Pack;
    auto values = load_relative<P, D>(Union<Reads, List<InverseSupport>>{}, state.columns, cell.frame(), i);
    values.h_inv = P(static_cast<T>(1 / h));
    Values<P, D, Adds> packs;
    set_zero(packs);
    const auto& tile = cell.candidates();
    for (int k = 0; k < tile.count; k += Cell::width) {
      const auto j = tile.template load<P>(k);
      terms(packs, values, j, gather_pair<P, D>(state.smoothing, values, j));
    }
    accumulate(sums, packs);
  }

  KOKKOS_INLINE_FUNCTION Result advance(SupportSearch& search, Sums& sums, double& move) const {
    const Parameters& p = state.parameters;
    return search.template advance<D>(sums.n, sums.dn_dh, p.neighbours, accept, p.h_max, move);
  }

  /// Carries the sums over to the final h and stores them.
  KOKKOS_INLINE_FUNCTION void finish(int i, const SupportSearch& search, Sums& sums, double move) const {
    sums.n += sums.dn_dh * move;
    if constexpr (contains<Density, Adds>) {
      sums.rho += sums.drho_dh * move;
      if constexpr (contains<VelocityDivergence, Adds>) sums.div_v /= sums.rho;
      if constexpr (contains<VelocityCurl, Adds>) sums.curl_v = (1 / sums.rho) * sums.curl_v;
    }
    state.columns.store(i, sums);
    state.template at<Support>(i) = search.h;
    state.template at<InverseSupport>(i) = 1 / search.h;
  }

  /// One thread per particle: every evaluation walks the tree again.
  KOKKOS_INLINE_FUNCTION void operator()(int i, SupportCounts& counts) const {
    SupportSearch search{state.template at<Support>(i)};
    Result result = Result::search;
    Sums sums;
    double move = 0;
    while (result == Result::search) {
      const SupportSearch trial = search;
      set_zero(sums);
      ThreadWalk<T, D, Reads, Reach::gather, Columns> walk{state.tree, state.columns};
      auto values = walk.target(i);
      values.h_inv = static_cast<T>(1 / trial.h);
      walk.for_each(i, trial.h, [&](const auto& j) {
        Values<T, D, Adds> pair_sums;
        set_zero(pair_sums);
        terms(pair_sums, values, j, gather_pair<T, D>(state.smoothing, values, j));
        accumulate(sums, pair_sums);
      });
      result = advance(search, sums, move);
    }
    finish(i, search, sums, move);
    counts.count(search, result);
  }

  /// A team of one host thread per cell, with tiles.
  KOKKOS_INLINE_FUNCTION void operator()(const typename Policy::member_type& team, SupportCounts& counts) const {
    Cell cell(team.team_scratch(scratch_level).get_shmem(Cell::scratch_bytes()), state.tree, state.columns,
              team.league_rank());
    const Bounds<D> all = root(state.tree);
    SupportSearch searches[cell_size];
    Sums sums[cell_size];
    bool pending[cell_size];
    const int begin = cell.begin(), n = cell.end() - begin;
    double largest = 0;
    for (int k = 0; k < n; ++k) {
      searches[k] = {state.template at<Support>(begin + k)};
      pending[k] = true;
      largest = max(largest, searches[k].h);
    }
    const auto advance_one = [&](int k) {
      double move = 0;
      const Result result = advance(searches[k], sums[k], move);
      if (result == Result::search) return;
      pending[k] = false;
      finish(begin + k, searches[k], sums[k], move);
      counts.count(searches[k], result);
    };
    for (double margin = 1.02; largest > 0; margin = 1.3) {
      const double reach = margin * largest;
      for (int k = 0; k < n; ++k)
        if (pending[k]) set_zero(sums[k]);
      bool in_one_tile = false;
      cell.collect(all, reach, [&](bool whole) {
        in_one_tile = whole;
        for (int s = cell.first_sub_cell(); s < cell.last_sub_cell(); ++s)
          sweep(cell, s, searches, sums, pending, whole ? reach : 0, advance_one);
      });
      if (!in_one_tile)
        for (int k = 0; k < n; ++k)
          if (pending[k]) advance_one(k);
      largest = 0;
      for (int k = 0; k < n; ++k)
        if (pending[k]) largest = max(largest, searches[k].h);
    }
  }

  /// Adds the tile's share to the sums of the pending particles of a sub-cell; where the tile holds everything within
  /// `whole_reach`, follows each search as far as that goes.
  template <class Advance>
  KOKKOS_INLINE_FUNCTION void sweep(Cell& cell, int sub_cell, SupportSearch* searches, Sums* sums, bool* pending,
                                    double whole_reach, const Advance& advance_one) const {
    const int from = sub_cell * sub_cell_size, to = min(from + sub_cell_size, state.n), base = cell.begin();
    double reach = 0;
    for (int i = from; i < to; ++i)
      if (pending[i - base]) reach = max(reach, searches[i - base].h);
    if (reach == 0) return;
    reach = whole_reach > 0 ? min(1.02 * reach, whole_reach) : reach;
    cell.select(sub_cell, reach);
    for (int i = from; i < to; ++i) {
      const int k = i - base;
      while (pending[k] && !(searches[k].h > reach)) {  // a NaN is met and fails
        if (whole_reach > 0) set_zero(sums[k]);
        add_sums(cell, i, searches[k].h, sums[k]);
        if (whole_reach == 0) break;
        advance_one(k);
      }
    }
  }
};

}  // namespace detail

/// Support radii, n, rho and the other gather sums of every particle, by Newton's method from the present h (S12 eq 6,
/// 11). A search ends when its step is below accept * h; the sums are then carried over to first order.
template <class S>
SupportCounts find_support(const State<S>& state, double accept) {
  using Find = detail::FindSupport<S>;
  const Find find{state, typename S::DensityTerms(state.parameters), accept};
  SupportCounts counts;
  if (state.n == 0) return counts;
  if constexpr (tiles_pay) {
    auto policy = typename Find::Policy(state.tree.cells(), 1)
                      .set_scratch_size(Find::scratch_level, Kokkos::PerTeam(Find::Cell::scratch_bytes()));
    Kokkos::parallel_reduce("smoothing length", policy, find, Kokkos::Sum<SupportCounts>(counts));
  } else {
    Kokkos::parallel_reduce("smoothing length", Kokkos::RangePolicy<ExecutionSpace>(0, state.n), find,
                            Kokkos::Sum<SupportCounts>(counts));
  }
  return counts;
}

}  // namespace sphk

template <>
struct Kokkos::reduction_identity<sphk::SupportCounts> {
  KOKKOS_FORCEINLINE_FUNCTION static sphk::SupportCounts sum() { return {}; }
};
