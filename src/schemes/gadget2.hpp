// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/terms/pressure_gradient_conservative.hpp"
#include "kernels/terms/signal_velocity.hpp"
#include "kernels/terms/viscosity_signal_velocity.hpp"
#include "src/schemes/step.hpp"

namespace sphk {

/// Classic SPH as in GADGET-2 (Springel 2005): entropy, grad-h, signal-velocity viscosity with the Balsara switch.
struct Gadget2 {
  static constexpr SchemeFacts facts{
      .name = "gadget2", .summary = "classic SPH as in GADGET-2 (Springel 2005): entropy, grad-h", .s12_label = "SPH"};

  struct Entropy : Recipe<EntropyForm, ClassicDensity,
                          TermSet<PressureGradientConservative, ViscositySignalVelocity<>, SignalVelocity>,
                          Step<StateEquation, BalsaraFactor, NoBalsaraFactor, GradH>> {
    using Kernels = Curated<List<>, List<CubicSpline>, List<CubicSpline, WendlandC6>>;
  };
  using Lean = ByDimension<List<>, List<CubicSpline>, List<CubicSpline>>;
  using Recipes = Union<List<Entropy>, LeanClassic<Entropy, ViscositySignalVelocity, Lean>>;
};

}  // namespace sphk
