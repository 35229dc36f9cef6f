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

/// A run of scheme S between two passes.
template <class S>
struct Run {
  explicit Run(State<S> loaded) : state(std::move(loaded)) {}
  State<S> state;
  Sorter<S::dimension, typename Particles<typename S::Layout>::Columns> sorter;
  double time = 0;
  double dt = 0;  ///< of the step in progress
  long step = 0;
  int steps_since_sort = 0;
  double accept = 0;       ///< relative move at which a search for h ends
  SupportCounts searches;  ///< of the last pass
  StepLimit limit;         ///< of the next step
};

}  // namespace sphk

template <>
struct Kokkos::reduction_identity<sphk::StepLimit> {
  KOKKOS_FORCEINLINE_FUNCTION static sphk::StepLimit sum() { return {}; }
};
