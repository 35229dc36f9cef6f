// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/rt_pressure.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

/// SPHS with the RT pressure (S12 App. A), the negative control: smooth pressures cost the kernel its sampling where
/// entropies differ much.
struct SphsRt {
  static constexpr SchemeFacts facts{.name = "sphs-rt",
                                     .summary = "SPHS with the RT pressure, a negative control (S12 App. A)",
                                     .usual = wide_kernels,
                                     .steps = own_steps,
                                     .differs = "no mass dissipation"};

  struct Entropy
      : Recipe<EntropyForm, TermSet<>,
               TermSet<PressureGradientTsph, ViscositySwitched<>, EntropyDissipation<>, SignalVelocity>,
               typename Before<StateEquation, RtPressure, Gradients, ConvergenceSwitch, GivenAlpha>::Then<>> {
    using Kernels = Curated<List<>, List<>, List<Hoct<4>>>;
  };
  using Recipes = List<Entropy>;
};

}  // namespace sphk
