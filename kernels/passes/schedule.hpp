// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/step_passes.hpp"

namespace sphk {

namespace detail {

constexpr int block_power = StepClock::block_bits;

/// The largest power of two that is not above n, as its exponent.
KOKKOS_INLINE_FUNCTION int power_below(double n) {
  int power = 0;
  while (power < block_power && 2.0 * static_cast<double>(Ticks(1) << power) <= n) ++power;
  return power;
}

template <class L>
struct MarkActive {
  Particles<L> state;
  Kokkos::View<StepRange*, MemorySpace> ranges;
  KOKKOS_INLINE_FUNCTION void operator()(int cell, long& count) const {
    TargetMask mask = 0;
    if (ranges(state.tree.first[1] + cell).first_end == state.clock.next) {
      const int begin = cell * cell_size, end = min(begin + cell_size, state.n);
      for (int i = begin; i < end; ++i)
        if (state.clock.end(i) == state.clock.next) mask |= TargetMask(1) << (i - begin), ++count;
    }
    state.active.masks(cell) = mask;
  }
};

struct ListCells {
  ParticleSubset subset;
  KOKKOS_INLINE_FUNCTION void operator()(int cell, int& place, bool final) const {
    if (subset.masks(cell) == 0) return;
    if (final) subset.cell_numbers(place) = cell;
    ++place;
  }
};

/// Marks the cells from which pairs of the active particles of a cell may read, a fifth further than their supports
/// reach as they are now.
template <class L>
struct MarkNear {
  static constexpr int D = L::dimension;
  Particles<L> state;
  Kokkos::View<TargetMask*, MemorySpace> near;
  KOKKOS_INLINE_FUNCTION void operator()(int k) const {
    const int cell = state.active.cell(k);
    Bounds<D> box = Bounds<D>::empty();
    for_each_of(state.active.targets(state.tree, cell), cell * cell_size,
                [&](int i) { box.include(point(state.columns, i)); });
    walk(
        state.tree, root(state.tree), box,
        [&](const auto& h) {
          using P = std::remove_cvref_t<decltype(h)>;
          return P(1.2) * sphk::max(P(box.h_max), h);
        },
        [](int, const double*) {},
        [&](int level, int node) {
          if (level == 1) Kokkos::atomic_store(&near(node), TargetMask(1));
          return level == 1;
        });
  }
};

/// The largest power-of-two step that a particle may take from `start`: not above what it asks for, and ending where
/// steps of its length end.
template <class L>
struct AssignSteps {
  Particles<L> state;
  Ticks start;
  double longest;  ///< as a time
  KOKKOS_INLINE_FUNCTION void operator()(int k) const {
    const int cell = state.active.cell(k);
    for_each_of(state.active.targets(state.tree, cell), cell * cell_size, [&](int i) {
      int power = power_below(min(state.step_asked(i), longest) / state.clock.tick);
      state.clock.power(i) = static_cast<std::uint8_t>(power);
      while (start % (Ticks(1) << power) != 0) --power;
      state.clock.begin(i) = start;
      state.clock.end(i) = start + (Ticks(1) << power);
    });
  }
};

/// The ranges of some cells and of their sub-cells.
template <class L>
struct FitRanges {
  Particles<L> state;
  ParticleSubset cells;
  Kokkos::View<StepRange*, MemorySpace> ranges;
  KOKKOS_INLINE_FUNCTION void operator()(int k) const {
    const StepClock& clock = state.clock;
    const int cell = cells.cell(k), last = min((cell + 1) * fan_out, state.tree.count(0));
    StepRange whole;
    for (int s = cell * fan_out; s < last; ++s) {
      StepRange part;
      const int from = s * sub_cell_size, to = min(from + sub_cell_size, state.n);
      for (int i = from; i < to; ++i) part.include({clock.power(i), clock.power(i), clock.end(i)});
      ranges(state.tree.first[0] + s) = part;
      whole.include(part);
    }
    ranges(state.tree.first[1] + cell) = whole;
  }
};

/// Those of the nodes above.
template <int D>
struct FitRangesAbove {
  CellTree<D> tree;
  Kokkos::View<StepRange*, MemorySpace> ranges;
  int level;
  KOKKOS_INLINE_FUNCTION void operator()(int k) const {
    StepRange whole;
    for (int child = k * fan_out, end = min(child + fan_out, tree.count(level - 1)); child < end; ++child)
      whole.include(ranges(tree.first[level - 1] + child));
    ranges(tree.first[level] + k) = whole;
  }
};

/// Caps the nominal steps of neighbours, one of them among the `sources`, that are more than `apart` powers of two from
/// each other. A woken particle's step ends with the next step of its nominal length, early that is: were its
/// neighbours held to that, each would wake the next, and none would sleep.
template <class L>
struct CapSteps {
  static constexpr int D = L::dimension;
  Particles<L> state;
  ParticleSubset sources;
  Kokkos::View<StepRange*, MemorySpace> ranges;
  Kokkos::View<int*, MemorySpace> caps;
  Kokkos::View<TargetMask*, MemorySpace> capped;
  int apart;

  KOKKOS_INLINE_FUNCTION void operator()(int k) const {
    const int cell = sources.cell(k / fan_out), child = k % fan_out, from = (cell * fan_out + child) * sub_cell_size;
    const TargetMask mask = sources.targets(state.tree, cell) >> (child * sub_cell_size) & 0xff;
    if (mask == 0) return;
    Bounds<D> box = Bounds<D>::empty();
    StepRange here;
    for_each_of(mask, from, [&](int i) {
      box.include(point(state.columns, i));
      here.include({state.clock.power(i), state.clock.power(i)});
    });
    walk(
        state.tree, root(state.tree), box,
        [&](const auto& h) { return sphk::max(std::remove_cvref_t<decltype(h)>(box.h_max), h); },
        [&](int other, const double* shift) {
          for_each_of(mask, from, [&](int i) { cap_neighbours(i, other, shift); });
        },
        [&](int level, int node) {
          const StepRange& there = ranges(state.tree.first[level] + node);
          return there.most <= here.least + apart && here.most <= there.least + apart;
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
      cap(j, state.clock.power(i) + apart);
      cap(i, state.clock.power(j) + apart);
    }
  }
  KOKKOS_INLINE_FUNCTION void cap(int i, int power) const {
    if (state.clock.power(i) <= power) return;
    Kokkos::atomic_min(&caps(i), power);
    Kokkos::atomic_or(&capped(i / cell_size), TargetMask(1) << (i % cell_size));
  }
};

/// The drift goes with the velocity at the middle of the step. Where the step ends after `done` of its length, x = x_0
/// + v_0 t + a t^2/2 wants the velocity at the middle of what is done.
template <class L>
KOKKOS_INLINE_FUNCTION void cut_drift(const Particles<L>& state, int i, double done, double length) {
  for (int d = 0; d < L::dimension; ++d)
    state.template at<Position>(i, d) += 0.5 * done * (done - length) * state.template at<Acceleration>(i, d);
}

/// Shortens the steps of capped particles. One in the midst of its step is woken: its step ends now, and a shorter one
/// begins. Of the subset remain those whose step begins at `start`.
template <class L>
struct ApplyCaps {
  Particles<L> state;
  ParticleSubset capped;
  Kokkos::View<int*, MemorySpace> caps;
  Ticks start;
  KOKKOS_INLINE_FUNCTION void operator()(int k) const {
    const int cell = capped.cell(k);
    TargetMask begun = 0;
    for_each_of(capped.masks(cell), cell * cell_size, [&](int i) {
      const Ticks step = Ticks(1) << caps(i), ends = (start / step + 1) * step;
      Ticks &begin = state.clock.begin(i), &end = state.clock.end(i);
      state.clock.power(i) = static_cast<std::uint8_t>(caps(i));
      caps(i) = block_power;
      if (ends < end) {
        if (begin < start)
          cut_drift(state, i, static_cast<double>(start - begin) * state.clock.tick, state.clock.step_of(i));
        begin = start;
        end = ends;
      }
      if (begin == start) begun |= TargetMask(1) << (i % cell_size);
    });
    capped.masks(cell) = begun;
  }
};

struct ClearMasks {
  ParticleSubset subset;
  KOKKOS_INLINE_FUNCTION void operator()(int k) const { subset.masks(subset.cell_numbers(k)) = 0; }
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

struct FirstEnd {
  Kokkos::View<StepRange*, MemorySpace> ranges;
  int from;
  KOKKOS_INLINE_FUNCTION void operator()(int k, Ticks& first) const { first = min(first, ranges(from + k).first_end); }
};

template <class F>
void for_cells(const char* name, int count, const F& f) {
  Kokkos::parallel_for(name, Kokkos::RangePolicy<ExecutionSpace>(0, count), f);
}

template <class L>
void fit_ranges_of(const Particles<L>& state, const Schedule& schedule, const ParticleSubset& cells) {
  const auto& tree = state.tree;
  for_cells("ranges of steps", cells.cells(tree), FitRanges<L>{state, cells, schedule.ranges});
  for (int level = 2; level < tree.levels; ++level)
    for_cells("ranges of steps", tree.count(level), FitRangesAbove<L::dimension>{tree, schedule.ranges, level});
}

inline void list_cells(ParticleSubset& subset, int cells) {
  Kokkos::parallel_scan("cells of a subset", Kokkos::RangePolicy<ExecutionSpace>(0, cells), ListCells{subset},
                        subset.count);
}

/// One round over the neighbours of the sources: their steps come within `apart` powers of two. `capped` becomes those
/// whose steps change.
template <class L>
void limit_once(const Particles<L>& state, const Schedule& schedule, const ParticleSubset& sources,
                ParticleSubset& capped, int apart, Ticks start) {
  const auto& tree = state.tree;
  for_cells("cap steps", sources.cells(tree) * fan_out,
            CapSteps<L>{state, sources, schedule.ranges, schedule.caps, capped.masks, apart});
  list_cells(capped, tree.cells());
  if (capped.count == 0) return;
  for_cells("apply caps", capped.count, ApplyCaps<L>{state, capped, schedule.caps, start});
  fit_ranges_of(state, schedule, capped);
}

template <class L>
void limit_steps(const Particles<L>& state, const Schedule& schedule, Ticks start) {
  ParticleSubset sources = state.active, capped = schedule.capped[0], other = schedule.capped[1];
  do {
    limit_once(state, schedule, sources, capped, 2, start);
    for_cells("clear masks", other.count, ClearMasks{other});
    other.count = 0;
    sources = capped;
    std::swap(capped, other);
  } while (sources.count > 0);
}

/// Neighbours that ask for unlike steps begin with the shorter one, and so do the neighbours of these: farther away a
/// longer first step does no harm, and nearer it costs energy where gas on a plane expands.
template <class L>
void begin_together(const Particles<L>& state, const Schedule& schedule, Ticks start) {
  for (int round = 0; round < 2; ++round) {
    ParticleSubset capped = schedule.capped[0];
    limit_once(state, schedule, state.active, capped, 0, start);
    for_cells("clear masks", capped.count, ClearMasks{capped});
  }
}

}  // namespace detail

template <class L>
void fit_ranges(const Particles<L>& state, const Schedule& schedule) {
  detail::fit_ranges_of(state, schedule, {});
}

template <class L>
void assign_steps(const Particles<L>& state, const Schedule& schedule, Ticks start) {
  double longest = schedule.longest;
  if (schedule.starting && start > 0) longest = min(longest, static_cast<double>(start) * state.clock.tick);
  detail::for_cells("assign steps", state.active.cells(state.tree), detail::AssignSteps<L>{state, start, longest});
  detail::fit_ranges_of(state, schedule, state.active);
  if (schedule.starting && start == 0) detail::begin_together(state, schedule, start);
  if (schedule.limiter) detail::limit_steps(state, schedule, start);
}

template <class L>
void wake_all(const Particles<L>& state) {
  Kokkos::parallel_for("wake all", Kokkos::RangePolicy<ExecutionSpace>(0, state.n), detail::CutShort<L>{state});
}

template <class L>
Ticks first_end(const Particles<L>& state, const Schedule& schedule) {
  const int top = state.tree.levels - 1;
  Ticks first = StepClock::block;
  Kokkos::parallel_reduce("first end", Kokkos::RangePolicy<ExecutionSpace>(0, state.tree.count(top)),
                          detail::FirstEnd{schedule.ranges, state.tree.first[top]}, Kokkos::Min<Ticks>(first));
  return first;
}

template <class L>
long mark_active(Particles<L>& state, Schedule& schedule) {
  if (!state.clock.individual) return state.n;
  long count = 0;
  const int cells = state.tree.cells();
  Kokkos::parallel_reduce("mark active", Kokkos::RangePolicy<ExecutionSpace>(0, cells),
                          detail::MarkActive<L>{state, schedule.ranges}, Kokkos::Sum<long>(count));
  detail::list_cells(state.active, cells);
  state.active.everyone = count == state.n;
  ParticleSubset& near = schedule.near;
  near.everyone = state.active.everyone;
  if (near.everyone) return count;
  Kokkos::deep_copy(ExecutionSpace(), near.masks, 0);
  detail::for_cells("cells near the active particles", state.active.count, detail::MarkNear<L>{state, near.masks});
  detail::list_cells(near, cells);
  return count;
}

}  // namespace sphk
