// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/state.hpp"
#include "kernels/passes/support_search.hpp"

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

/// The smallest time-step that a particle asks for, and which one.
struct StepLimit {
  double dt = 1e300;
  int particle = -1;
  KOKKOS_INLINE_FUNCTION StepLimit& operator+=(const StepLimit& b) {
    if (b.dt < dt || (b.dt == dt && b.particle < particle)) *this = b;
    return *this;
  }
};

/// Particles whose neighbours did not allow a second-order fit of the velocities.
struct FitCounts {
  long linear = 0;  ///< fitted to first order
  long sph = 0;     ///< standard SPH estimate
  KOKKOS_INLINE_FUNCTION FitCounts& operator+=(const FitCounts& b) {
    linear += b.linear;
    sph += b.sph;
    return *this;
  }
};

/// Kicks that would have taken more than half of what a particle has of its thermal variable or mass.
struct LossCounts {
  long heat = 0, mass = 0;
  KOKKOS_INLINE_FUNCTION LossCounts& operator+=(const LossCounts& b) {
    heat += b.heat;
    mass += b.mass;
    return *this;
  }
};

/// What the passes of a step had to make do with.
struct StepCounts {
  SupportCounts searches;
  FitCounts fits;
  LossCounts losses;
  StepCounts& operator+=(const StepCounts& b) {
    searches += b.searches;
    fits += b.fits;
    losses += b.losses;
    return *this;
  }
};

/// Nominal steps of a set of particles, as powers of two, and where the first of them ends.
struct StepRange {
  int least = StepClock::block_bits, most = 0;
  Ticks first_end = StepClock::block;
  KOKKOS_INLINE_FUNCTION void include(const StepRange& b) {
    least = min(least, b.least);
    most = max(most, b.most);
    first_end = min(first_end, b.first_end);
  }
};

/// What a hierarchy of steps needs beside the clock.
struct Schedule {
  double longest = 1e300;  ///< no step is longer
  bool limiter = true;     ///< neighbours stay within a factor 4
  bool starting = false;   ///< the run's first block: neighbours begin with one step, and none is longer than the run
  double updates_since_sort = 1e300;
  Kokkos::View<int*, MemorySpace> caps;          ///< powers that neighbours allow; in the memory of the sort
  ParticleSubset capped[2];                      ///< whose caps are below their steps; by turns
  ParticleSubset near;                           ///< cells from which pairs of active particles may read
  Kokkos::View<StepRange*, MemorySpace> ranges;  ///< of every node of the tree
};

/// Rows `first`, ..., `first + count - 1` of the columns.
template <class L>
ColumnNumbers rows_of(const Particles<L>& state, int first, int count) {
  const auto stride = static_cast<std::size_t>(state.columns.stride), begin = static_cast<std::size_t>(first) * stride;
  return Kokkos::subview(state.columns.data, std::pair(begin, begin + static_cast<std::size_t>(count) * stride));
}

/// The rows that sorts work in where one step serves all particles: the search for support radii, which follows the
/// sort, computes them anew.
template <class L>
ColumnNumbers rows_for_sorts(const Particles<L>& state) {
  constexpr int D = L::dimension, first = component_offset<D, InverseSupport, BaseFields>;
  static_assert(component_offset<D, NumberDensity, BaseFields> == first + 1 &&
                component_offset<D, NumberDensitySlope, BaseFields> == first + 2 && Sorter<D>::rows == 3);
  return rows_of(state, first, Sorter<D>::rows);
}

/// A run between two passes. L is a BaseLayout: passes that know more see the same particles by state.as<>().
template <class L>
struct Run {
  static_assert(is_base<L>);
  explicit Run(Particles<L> loaded)
      : state(std::move(loaded)), sorter(state.n, rows_for_sorts(state), state.columns.stride) {}
  Particles<L> state;
  Sorter<L::dimension> sorter;
  double time = 0;
  long step = 0;
  long active_count = 0;  ///< particles computed in the last step
  Schedule schedule;
  Given given;        ///< the numbers of terms and passes
  double accept = 0;  ///< relative move at which a search for h ends
  StepCounts counts;  ///< of the last step
  StepLimit limit;    ///< of the next step
};

/// A row that nobody needs until the next step begins: of the sort's memory, or the half-step values of one step for
/// all, which the opening kick takes anew.
template <class L>
ColumnNumbers idle_row(const Run<L>& run) {
  if (run.state.clock.individual) return Kokkos::subview(run.sorter.memory(), std::pair(0, run.state.columns.stride));
  return rows_of(run.state, component_offset<L::dimension, HalfStepThermal, BaseFields>, 1);
}

template <class L>
using RunOf = Run<BaseLayout<L>>;

/// Adds the pull of the central mass to the accelerations of the active particles. This and the next: defined in
/// sorted_cells.hpp, compiled once for all schemes.
template <class L>
void pull_to_centre(const Particles<L>& state);
/// Gives a row of the columns one value.
template <class L>
void fill_row(const Particles<L>& state, int row, double value);

/// Gives every particle the same value of field F, where there is such a field.
template <class F, class L>
void fill(const RunOf<L>& run, double value) {
  if constexpr (contains<F, typename L::Fields>)
    fill_row(run.state, component_offset<L::dimension, F, typename L::Fields>, value);
}

/// A pass over pairs needs the scheme's smoothing kernel and pair arithmetic, `run<S>(run, smoothing)`; others know its
/// layout alone, `run<L>(run)`.
template <class P>
inline constexpr bool is_over_pairs = requires {
  P::over_pairs;
};

}  // namespace sphk

template <>
struct Kokkos::reduction_identity<sphk::FitCounts> {
  KOKKOS_FORCEINLINE_FUNCTION static sphk::FitCounts sum() { return {}; }
};
template <>
struct Kokkos::reduction_identity<sphk::LossCounts> {
  KOKKOS_FORCEINLINE_FUNCTION static sphk::LossCounts sum() { return {}; }
};
template <>
struct Kokkos::reduction_identity<sphk::StepLimit> {
  KOKKOS_FORCEINLINE_FUNCTION static sphk::StepLimit sum() { return {}; }
};
template <>
struct Kokkos::reduction_identity<sphk::SupportCounts> {
  KOKKOS_FORCEINLINE_FUNCTION static sphk::SupportCounts sum() { return {}; }
};
