// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/run.hpp"
#include "kernels/terms/tensile_correction.hpp"

namespace sphk {

namespace detail {

template <class S>
struct EvaluateSpacingKernel {
  static constexpr int D = S::dimension;
  State<S> state;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    if (!state.active.contains(i)) return;
    const double h_inv = 1 / state.template at<Support>(i);
    const double d = Kokkos::pow(state.template at<NumberDensity>(i), -1.0 / D);
    const double W = state.smoothing.norm * power_of_dimension<D>(h_inv) * state.smoothing.kernel.w(d * h_inv);
    state.template at<InverseSpacingKernel>(i) = W > 0 ? 1 / W : 0;
  }
};

}  // namespace detail

/// W at the mean distance of particles, against which the tensile correction holds its pairs (Monaghan 2000).
struct SpacingKernel {
  static constexpr const char* name = "kernel at the mean distance";
  static constexpr bool over_pairs = true;  // needs the smoothing kernel
  using Reads = List<Support, NumberDensity>;
  using Writes = List<InverseSpacingKernel>;
  template <class S>
  static void run(RunOf<typename S::Layout>& run, const SmoothingOf<S>& smoothing) {
    const State<S> state{run.state.template as<typename S::Layout>(), smoothing};
    Kokkos::parallel_for(name, Kokkos::RangePolicy<ExecutionSpace>(0, state.n),
                         detail::EvaluateSpacingKernel<S>{state});
  }
};

}  // namespace sphk
