// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/run.hpp"

namespace sphk {

namespace detail {
template <class L>
struct DampVelocity {
  Particles<L> state;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    const double rate = state.template at<SoundSpeed>(i) / state.template at<Support>(i);
    const double factor = Kokkos::exp(-rate * state.clock.dt);
    for (int d = 0; d < L::dimension; ++d) state.template at<Velocity>(i, d) *= factor;
  }
};
}  // namespace detail

/// Friction dv/dt = -(c/h) v: waves of the particle spacing die within a few of their periods, and the gas settles.
struct Damping {
  static constexpr const char* name = "damping";
  static constexpr bool essential = true;
  using Reads = List<SoundSpeed, Support>;
  using Writes = List<Velocity>;
  template <class L>
  static void run(RunOf<L>& run) {
    Kokkos::parallel_for(name, Kokkos::RangePolicy<ExecutionSpace>(0, run.state.n),
                         detail::DampVelocity<L>{run.state.template as<L>()});
  }
};

}  // namespace sphk
