// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/general_density.hpp"

namespace sphk {

namespace detail {

/// P = A rho^gamma with the generalised density, and the speed of sound that goes with it and the observable density.
template <class L>
struct TakeRtPressure {
  Particles<L> state;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    if (!state.active.contains(i)) return;
    const double gamma = state.parameters.gamma;
    const double P =
        L::ThermalForm::pressure(state.template at<Thermal>(i), state.template at<GeneralDensity>(i), gamma);
    state.template at<Pressure>(i) = P;
    state.template at<SoundSpeed>(i) = Kokkos::sqrt(gamma * P * state.template at<InverseDensity>(i));
  }
};

}  // namespace detail

/// The pressure of Ritchie & Thomas (2001), smooth by construction, in place of A rho^gamma, and nothing else of
/// theirs: P_i = [sum_j m_j A_j^(1/gamma) Wbar]^gamma (R10 eq 54; S12 eq 20). S12's App. A shows where it fails.
struct RtPressure {
  using StateDensity = GeneralDensity;
  static constexpr const char* name = "RT pressure";
  static constexpr bool over_pairs = true;
  using Reads = List<Position, InverseSupport, Mass, Thermal, Density, InverseDensity, Pressure, SoundSpeed>;
  using Writes = List<InverseEta, GeneralDensity, Pressure, SoundSpeed>;
  using Keeps = Writes;
  template <class S>
  static void run(RunOf<typename S::Layout>& run, const SmoothingOf<S>& smoothing) {
    using L = typename S::Layout;
    GeneralContinuity<InverseEntropyRoot>::run<S>(run, smoothing);
    Kokkos::parallel_for(name, Kokkos::RangePolicy<ExecutionSpace>(0, run.state.n),
                         detail::TakeRtPressure<L>{run.state.template as<L>()});
  }
};

}  // namespace sphk
