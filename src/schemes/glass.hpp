// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/terms/pressure_gradient_conservative.hpp"
#include "kernels/terms/signal_velocity.hpp"
#include "src/schemes/step.hpp"

namespace sphk {

/// Isentropic gas with friction: it settles into a glass, an even arrangement without a preferred direction.
struct Glass {
  static constexpr SchemeFacts facts{
      .name = "glass", .summary = "settles random places into a glass", .courant = 0.4, .hidden = true};

  struct Entropy
      : Recipe<EntropyForm, TermSet<>, TermSet<PressureGradientConservative, SignalVelocity>,
               Passes<KickDrift, SortedCells, SmoothingLength, StateEquation, GradH, Rates, KickTimeStep, Damping>> {
    using Kernels = ByDimension<List<CubicSpline>, List<CubicSpline>, List<CubicSpline>>;
    using PairNumbers = List<float>;
  };
  using Recipes = List<Entropy>;
};

}  // namespace sphk
