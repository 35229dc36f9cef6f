#pragma once

#include "kernels/passes/smoothing_length.hpp"

namespace sphk {

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

/// Shortest and longest step of a set of particles.
struct TickRange {
  Ticks shortest = StepClock::block, longest = 0;
  KOKKOS_INLINE_FUNCTION void include(Ticks ticks) { include(TickRange{ticks, ticks}); }
  KOKKOS_INLINE_FUNCTION void include(const TickRange& b) {
    shortest = min(shortest, b.shortest);
    longest = max(longest, b.longest);
  }
};

/// What a hierarchy of steps needs beside the clock.
struct Schedule {
  double longest = 1e300;  ///< no step is longer
  bool limiter = true;     ///< neighbours stay within a factor 4
  double updates_since_sort = 1e300;
  Kokkos::View<Ticks*, MemorySpace> caps, other;  ///< `other`: where the sort puts begins and ends
  Kokkos::View<TickRange*, MemorySpace> ranges;   ///< of every node of the tree
};

/// A run of scheme S between two passes.
template <class S>
struct Run {
  explicit Run(State<S> loaded) : state(std::move(loaded)) {}
  State<S> state;
  Sorter<S::dimension, typename Particles<typename S::Layout>::Columns> sorter;
  double time = 0;
  long step = 0;
  long active_count = 0;  ///< particles computed in the last step
  Schedule schedule;
  double accept = 0;       ///< relative move at which a search for h ends
  SupportCounts searches;  ///< of the last pass
  FitCounts fits;          ///< of the last pass
  StepLimit limit;         ///< of the next step
};

}  // namespace sphk

template <>
struct Kokkos::reduction_identity<sphk::FitCounts> {
  KOKKOS_FORCEINLINE_FUNCTION static sphk::FitCounts sum() { return {}; }
};
template <>
struct Kokkos::reduction_identity<sphk::StepLimit> {
  KOKKOS_FORCEINLINE_FUNCTION static sphk::StepLimit sum() { return {}; }
};
