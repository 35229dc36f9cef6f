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

  /// The cell of a team of one host thread.
  Cell cell_of(const Team& team) const {
    const int cell = state.active.cell(team.league_rank());
    return Cell(team.team_scratch(scratch_level).get_shmem(Cell::scratch_bytes()), state.tree, state.columns, cell,
                state.active.targets(state.tree, cell));
  }
  /// Particle i in every lane, as its pairs see it.
  Values<Pack, D, TargetFields> target_of(const Cell& cell, int i) const {
    return load_relative<Pack, D>(TargetFields{}, state.columns, cell.frame(), i);
  }
};

namespace detail {
/// A loop over cells whose type the dispatch does not know: one for all loops, since a compiler takes a third of a
/// loop's time for its dispatch. A call a cell costs nothing.
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
