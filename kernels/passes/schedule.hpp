#pragma once

#include "kernels/passes/step_passes.hpp"

namespace sphk {

namespace detail {

KOKKOS_INLINE_FUNCTION Ticks power_of_two_below(double n) {
  Ticks ticks = 1;
  while (ticks < StepClock::block && 2.0 * static_cast<double>(ticks) <= n) ticks *= 2;
  return ticks;
}

template <class L>
struct MarkActive {
  Particles<L> state;
  KOKKOS_INLINE_FUNCTION void operator()(int cell, long& count) const {
    TargetMask mask = 0;
    const int begin = cell * cell_size, end = min(begin + cell_size, state.n);
    for (int i = begin; i < end; ++i)
      if (state.clock.end(i) == state.clock.next) mask |= TargetMask(1) << (i - begin), ++count;
    state.active.masks(cell) = mask;
  }
};

struct ListActiveCells {
  ActiveSet active;
  KOKKOS_INLINE_FUNCTION void operator()(int cell, int& place, bool final) const {
    if (active.masks(cell) == 0) return;
    if (final) active.cell_numbers(place) = cell;
    ++place;
  }
};

/// The largest power-of-two step that a particle may take from `start`: not above what it asks for, and ending where
/// steps of its length end.
template <class L>
struct AssignSteps {
  Particles<L> state;
  Ticks start;
  double longest;  ///< as a time
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    if (!state.active.contains(i)) return;
    Ticks ticks = power_of_two_below(min(state.step_asked(i), longest) / state.clock.tick);
    while (start % ticks != 0) ticks /= 2;
    state.clock.begin(i) = start;
    state.clock.end(i) = start + ticks;
  }
};

template <class L>
struct FitRanges {
  Particles<L> state;
  Kokkos::View<TickRange*, MemorySpace> ranges;
  int level;
  KOKKOS_INLINE_FUNCTION void operator()(int k) const {
    TickRange range;
    if (level == 0) {
      const int begin = k * sub_cell_size, end = min(begin + sub_cell_size, state.n);
      for (int i = begin; i < end; ++i) range.include(state.clock.end(i) - state.clock.begin(i));
    } else {
      const int begin = k * fan_out, end = min(begin + fan_out, state.tree.count(level - 1));
      for (int child = begin; child < end; ++child) range.include(ranges(state.tree.first[level - 1] + child));
    }
    ranges(state.tree.first[level] + k) = range;
  }
};

/// Caps the steps of neighbours that are further apart than a factor 4, where one of them begins its step at `start`.
template <class L>
struct CapSteps {
  static constexpr int D = L::dimension;
  Particles<L> state;
  Kokkos::View<TickRange*, MemorySpace> ranges;
  Kokkos::View<Ticks*, MemorySpace> caps;
  Ticks start;

  KOKKOS_INLINE_FUNCTION Ticks length(int i) const { return state.clock.end(i) - state.clock.begin(i); }
  KOKKOS_INLINE_FUNCTION void operator()(int sub_cell) const {
    const int from = sub_cell * sub_cell_size, to = min(from + sub_cell_size, state.n);
    Bounds<D> box = Bounds<D>::empty();
    TickRange here;
    for (int i = from; i < to; ++i)
      if (state.clock.begin(i) == start) box.include(point(state.columns, i)), here.include(length(i));
    if (here.longest == 0) return;
    walk(
        state.tree, root(state.tree), box,
        [&](const auto& h) { return sphk::max(std::remove_cvref_t<decltype(h)>(box.h_max), h); },
        [&](int other, const double* shift) {
          for (int i = from; i < to; ++i)
            if (state.clock.begin(i) == start) cap_neighbours(i, other, shift);
        },
        [&](int level, int k) {
          const TickRange& there = ranges(state.tree.first[level] + k);
          return there.longest <= 4 * here.shortest && here.longest <= 4 * there.shortest;
        });
  }
  KOKKOS_INLINE_FUNCTION void cap_neighbours(int i, int other, const double* shift) const {
    const int from = other * sub_cell_size, to = min(from + sub_cell_size, state.n);
    for (int j = from; j < to; ++j) {
      double r2 = 0;
      for (int d = 0; d < D; ++d) {
        const double x = state.template at<Position>(i, d) - state.template at<Position>(j, d) - shift[d];
        r2 += x * x;
      }
      const double h = max(state.template at<Support>(i), state.template at<Support>(j));
      if (r2 >= h * h) continue;
      if (length(j) > 4 * length(i)) Kokkos::atomic_min(&caps(j), 4 * length(i));
      if (length(i) > 4 * length(j)) Kokkos::atomic_min(&caps(i), 4 * length(j));
    }
  }
};

/// The drift goes with the velocity at the middle of the step. Where the step ends after `done` of its length, x = x_0
/// + v_0 t + a t^2/2 wants the velocity at the middle of what is done.
template <class L>
KOKKOS_INLINE_FUNCTION void cut_drift(const Particles<L>& state, int i, double done, double length) {
  for (int d = 0; d < L::dimension; ++d)
    state.template at<Position>(i, d) += 0.5 * done * (done - length) * state.template at<Acceleration>(i, d);
}

/// Shortens the steps that were capped. A particle in the midst of its step is woken: its step ends now, and a shorter
/// one begins.
template <class L>
struct ApplyCaps {
  Particles<L> state;
  Kokkos::View<Ticks*, MemorySpace> caps;
  Ticks start;
  KOKKOS_INLINE_FUNCTION void operator()(int i, int& changed) const {
    const Ticks cap = caps(i);
    caps(i) = StepClock::block;
    Ticks &begin = state.clock.begin(i), &end = state.clock.end(i);
    if (cap >= end - begin) return;
    const Ticks step = power_of_two_below(static_cast<double>(cap));
    const Ticks new_end = (start / step + 1) * step;
    if (new_end >= end) return;
    if (begin < start)
      cut_drift(state, i, static_cast<double>(start - begin) * state.clock.tick, state.clock.step_of(i));
    begin = start;
    end = new_end;
    changed = 1;
  }
};

/// Ends the step of every particle where the drift ended.
template <class L>
struct CutShort {
  Particles<L> state;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    const StepClock& clock = state.clock;
    if (clock.begin(i) < clock.now)
      cut_drift(state, i, static_cast<double>(clock.now - clock.begin(i)) * clock.tick, clock.step_of(i));
  }
};

template <class L>
struct FirstEnd {
  StepClock clock;
  KOKKOS_INLINE_FUNCTION void operator()(int i, Ticks& first) const { first = min(first, clock.end(i)); }
};

template <class L>
void limit_steps(const Particles<L>& state, const Schedule& schedule, Ticks start) {
  const auto& tree = state.tree;
  for (int changed = 1; changed > 0;) {
    for (int level = 0; level < tree.levels; ++level)
      Kokkos::parallel_for("ranges of steps", Kokkos::RangePolicy<ExecutionSpace>(0, tree.count(level)),
                           FitRanges<L>{state, schedule.ranges, level});
    Kokkos::parallel_for("cap steps", Kokkos::RangePolicy<ExecutionSpace>(0, tree.count(0)),
                         CapSteps<L>{state, schedule.ranges, schedule.caps, start});
    Kokkos::parallel_reduce("apply caps", Kokkos::RangePolicy<ExecutionSpace>(0, state.n),
                            ApplyCaps<L>{state, schedule.caps, start}, Kokkos::Max<int>(changed));
  }
}

}  // namespace detail

template <class L>
void assign_steps(const Particles<L>& state, const Schedule& schedule, Ticks start) {
  double longest = schedule.longest;
  if (schedule.starting && start > 0) longest = min(longest, static_cast<double>(start) * state.clock.tick);
  Kokkos::parallel_for("assign steps", Kokkos::RangePolicy<ExecutionSpace>(0, state.n),
                       detail::AssignSteps<L>{state, start, longest});
  if (schedule.limiter) detail::limit_steps(state, schedule, start);
}

template <class L>
void wake_all(const Particles<L>& state) {
  Kokkos::parallel_for("wake all", Kokkos::RangePolicy<ExecutionSpace>(0, state.n), detail::CutShort<L>{state});
}

template <class L>
Ticks first_end(const Particles<L>& state) {
  Ticks first = StepClock::block;
  Kokkos::parallel_reduce("first end", Kokkos::RangePolicy<ExecutionSpace>(0, state.n),
                          detail::FirstEnd<L>{state.clock}, Kokkos::Min<Ticks>(first));
  return first;
}

template <class L>
long mark_active(Particles<L>& state) {
  if (!state.clock.individual) return state.n;
  long count = 0;
  const Kokkos::RangePolicy<ExecutionSpace> cells(0, state.tree.cells());
  Kokkos::parallel_reduce("mark active", cells, detail::MarkActive<L>{state}, Kokkos::Sum<long>(count));
  Kokkos::parallel_scan("active cells", cells, detail::ListActiveCells{state.active}, state.active.count);
  state.active.everyone = count == state.n;
  return count;
}

}  // namespace sphk
