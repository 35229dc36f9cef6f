// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cells/thread_walk.hpp"
#include "kernels/cells/tiled_cell.hpp"
#include "kernels/passes/state.hpp"

namespace sphk {

/// Whether the pair loops of scheme S run with one thread a particle: on a GPU, and where a scheme asks for it, as
/// tests do that compare.
template <class S>
inline constexpr bool by_particles = !tiles_pay || requires {
  S::one_thread_a_particle;
};

/// What the loops over pairs of scheme S have in common. A loop derives from this and names the fields that it reads of
/// both sides. Drivers run it: by cells on a host, `serve(cell, counts...)`, or with one thread a particle, on a GPU
/// and as the reference of tests, `serve(walk, i, counts...)`; what a pair adds stands in one place for both.
template <class S, class FieldList, Reach reach>
struct PairLoop {
  static constexpr int D = S::dimension;
  static constexpr Reach mode = reach;
  static constexpr bool by_particles = sphk::by_particles<S>;
  using T = typename S::PairNumber;
  using Fields = FieldList;
  using Columns = typename Particles<typename S::Layout>::Columns;
  using Cell = TiledCell<T, D, Fields, mode, Columns>;
  using Pack = typename Cell::Pack;
  using Walk = ThreadWalk<T, D, Fields, mode, Columns>;
  using TargetFields = Union<List<Position, InverseSupport>, Fields>;

  /// Of so many or fewer targets in a cell each is served for itself.
  static constexpr int few_targets = 4;

  State<S> state;

  KOKKOS_INLINE_FUNCTION Sources<Columns> sources() const { return {state.tree, state.columns}; }
  KOKKOS_INLINE_FUNCTION Walk walk() const { return {state.columns, sources()}; }
  /// Whether lists of neighbours pay, or a sub-cell's candidates serve each of its particles, in and out of reach: a
  /// third of few are neighbours, and half of many.
  bool lists_pay() const {
    if constexpr (requires { S::Kernel::lane_by_lane; }) return true;
    return state.parameters.neighbours < 150;
  }

  /// Calls f(cell) for a cell: once for all of its targets, or for one after the other where they are few, whose
  /// neighbours have little in common, or the cell is too wide for that, in space or in velocities. `scratch`:
  /// Cell::scratch_bytes() of memory.
  template <class F>
  void for_targets_of(int number, void* scratch, F&& f) const {
    const TargetMask targets = state.active.targets(state.tree, number);
    const bool apart = std::popcount(targets) <= few_targets || is_wide(number) || is_torn(number);
    for (TargetMask left = targets; left != 0; left = apart ? left & (left - 1) : 0) {
      Cell cell(scratch, state.tree, state.columns, number, apart ? left & (~left + 1) : left, sources());
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
template <class... Sum>
struct ByCells {
  using Policy = Kokkos::TeamPolicy<ExecutionSpace, Kokkos::Schedule<Kokkos::Dynamic>>;
  static constexpr int scratch_level = 1;

  const void* loop;
  void (*serve)(const void*, int, void*, Sum&...);
  std::size_t scratch_bytes;
  void operator()(const typename Policy::member_type& team, Sum&... sum) const {
    serve(loop, team.league_rank(), team.team_scratch(scratch_level).get_shmem(scratch_bytes), sum...);
  }
};

template <class Loop, class... Sum>
void serve_cell(const void* of, int k, void* scratch, Sum&... sum) {
  const Loop& loop = *static_cast<const Loop*>(of);
  loop.for_targets_of(loop.state.active.cell(k), scratch, [&](typename Loop::Cell& cell) { loop.serve(cell, sum...); });
}

/// One thread a particle.
template <class Loop>
struct ByParticles {
  Loop loop;
  template <class... Sum>
  KOKKOS_INLINE_FUNCTION void operator()(int i, Sum&... sum) const {
    if (loop.state.active.contains(i)) loop.serve(loop.walk(), i, sum...);
  }
};

template <class Body, class Policy, class... Reducer>
void launch(const char* name, const Policy& policy, const Body& body, const Reducer&... reducer) {
  if constexpr (sizeof...(Reducer) == 0)
    Kokkos::parallel_for(name, policy, body);
  else
    Kokkos::parallel_reduce(name, policy, body, reducer...);
}

}  // namespace detail

/// Runs a pair loop over the active particles: by cells on a host, by particles on a GPU.
template <class Loop, class... Reducer>
void run_pairs(const char* name, const Loop& loop, const Reducer&... reducer) {
  const auto& state = loop.state;
  if (state.n == 0) return;
  if constexpr (Loop::by_particles) {
    detail::launch(name, Kokkos::RangePolicy<ExecutionSpace>(0, state.n), detail::ByParticles<Loop>{loop}, reducer...);
  } else {
    using Body = detail::ByCells<typename Reducer::value_type...>;
    auto policy = typename Body::Policy(state.active.cells(state.tree), 1);
    policy.set_scratch_size(Body::scratch_level, Kokkos::PerTeam(Loop::Cell::scratch_bytes()));
    detail::launch(name, policy,
                   Body{&loop, &detail::serve_cell<Loop, typename Reducer::value_type...>, Loop::Cell::scratch_bytes()},
                   reducer...);
  }
}

}  // namespace sphk
