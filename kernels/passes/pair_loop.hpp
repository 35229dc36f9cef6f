#pragma once

#include "kernels/cells/thread_walk.hpp"
#include "kernels/cells/tiled_cell.hpp"
#include "kernels/passes/state.hpp"

namespace sphk {

/// What the loops over pairs of scheme S have in common: a loop derives from this, names the fields that it reads of
/// both sides, and has one operator for a thread per particle and one for a team per cell.
template <class S, class FieldList, Reach mode>
struct PairLoop {
  static constexpr int D = S::dimension;
  using T = typename S::PairNumber;
  using Fields = FieldList;
  using Columns = typename Particles<typename S::Layout>::Columns;
  using Cell = TiledCell<T, D, Fields, mode, Columns>;
  using Pack = typename Cell::Pack;
  using Walk = ThreadWalk<T, D, Fields, mode, Columns>;
  using TargetFields = Union<List<Position, InverseSupport>, Fields>;
  using Policy = Kokkos::TeamPolicy<ExecutionSpace, Kokkos::Schedule<Kokkos::Dynamic>>;
  using Team = typename Policy::member_type;
  static constexpr int scratch_level = 1;

  State<S> state;

  /// Calls f(cell) for the cell of a team of one host thread: once for all of its targets, or for one after the other
  /// where the cell is too wide for that, in space or in velocities.
  template <class F>
  void for_targets_of(const Team& team, F&& f) const {
    const int number = state.active.cell(team.league_rank());
    const TargetMask targets = state.active.targets(state.tree, number);
    void* const scratch = team.team_scratch(scratch_level).get_shmem(Cell::scratch_bytes());
    const bool wide = is_wide(number) || is_torn(number);
    for (TargetMask left = targets; left != 0; left = wide ? left & (left - 1) : 0) {
      Cell cell(scratch, state.tree, state.columns, number, wide ? left & (~left + 1) : left);
      f(cell);
    }
  }
  /// Particle i in every lane, as its pairs see it.
  Values<Pack, D, TargetFields> target_of(const Cell& cell, int i) const {
    return load_relative<Pack, D>(TargetFields{}, state.columns, cell.frame(), i);
  }

 private:
  /// Is the cell so wide, for a particle far from the others is in it, that floats do not resolve its smallest support?
  bool is_wide(int cell) const {
    if constexpr (std::is_same_v<T, double>) return false;
    constexpr double widest = D == 1 ? 100 : 16;  // in supports: cells of even gas are 3 wide, in 1D 25
    const Bounds<D> bounds = state.tree.node(1, cell);
    double extent = 0, h_min = 1e300;
    for (int d = 0; d < D; ++d) extent = max(extent, bounds.hi[d] - bounds.lo[d]);
    const double* h = state.columns.template row<Support>();
    for (int i = cell * cell_size, end = min(i + cell_size, state.n); i < end; ++i) h_min = min(h_min, h[i]);
    return extent > widest * h_min;
  }
  /// Are its velocities so far apart that floats do not resolve the slowest signal among them? They need not where it
  /// is the neighbours that are so fast, since signals are as well, then.
  bool is_torn(int cell) const {
    using All = typename S::Layout::Fields;
    if constexpr (std::is_same_v<T, double> || !contains<Velocity, Fields> || !contains<MaxSignalVelocity, All>) {
      return false;
    } else {
      constexpr double widest = 1e4;  // floats then miss 1e-3 of the signal
      const int begin = cell * cell_size, end = min(begin + cell_size, state.n);
      const double* signal = state.columns.template row<MaxSignalVelocity>();
      double slowest = signal[begin], spread = 0;
      for (int i = begin; i < end; ++i) slowest = min(slowest, signal[i]);
      for (int d = 0; d < D; ++d) {
        const double* v = state.columns.template row<Velocity>(d);
        double lo = v[begin], hi = v[begin];
        for (int i = begin; i < end; ++i) lo = min(lo, v[i]), hi = max(hi, v[i]);
        spread = max(spread, hi - lo);
      }
      return slowest > 0 && spread > widest * slowest;
    }
  }
};

namespace detail {
/// A loop over cells whose type the dispatch does not know: one for all loops, since Kokkos' dispatch of each is up to
/// a quarter of a scheme's compile time. A call a cell costs nothing that can be measured.
template <class Team, class... Sum>
struct AnyLoop {
  const void* loop;
  void (*run)(const void*, const Team&, Sum&...);
  void operator()(const Team& team, Sum&... sum) const { run(loop, team, sum...); }
};
}  // namespace detail

/// Runs a pair loop over the active particles: by cells on a host, by particles on a GPU.
template <class Loop, class... Reducer>
void run_pairs(const char* name, const Loop& loop, const Reducer&... reducer) {
  const auto& state = loop.state;
  if (state.n == 0) return;
  const auto launch = [&](const auto& policy, const auto& body) {
    if constexpr (sizeof...(Reducer) == 0)
      Kokkos::parallel_for(name, policy, body);
    else
      Kokkos::parallel_reduce(name, policy, body, reducer...);
  };
  if constexpr (tiles_pay) {
    using Team = typename Loop::Team;
    auto policy = typename Loop::Policy(state.active.cells(state.tree), 1);
    policy.set_scratch_size(Loop::scratch_level, Kokkos::PerTeam(Loop::Cell::scratch_bytes()));
    launch(policy, detail::AnyLoop<Team, typename Reducer::value_type...>{
                       &loop, [](const void* of, const Team& team, typename Reducer::value_type&... sum) {
                         (*static_cast<const Loop*>(of))(team, sum...);
                       }});
  } else {
    launch(Kokkos::RangePolicy<ExecutionSpace>(0, state.n), loop);
  }
}

}  // namespace sphk
