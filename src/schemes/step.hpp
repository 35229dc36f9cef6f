// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/damping.hpp"
#include "kernels/terms/pair_limiter.hpp"
#include "kernels/terms/velocity_gradient.hpp"
#include "src/engine/scheme.hpp"
#include "src/schemes/scheme_facts.hpp"
#include "src/schemes/shared_loops.hpp"

namespace sphk {

/// A step: passes that prepare what the terms read, the rates, passes that follow them.
template <class... BeforeRates>
struct Before {
  template <class... AfterRates>
  using Then = Passes<KickDrift, SortedCells, ActiveParticles, SmoothingLength, BeforeRates..., Rates, AfterRates...,
                      CentralPull, KickTimeStep, NextSteps>;
};
template <class... BeforeRates>
using Step = typename Before<BeforeRates...>::template Then<>;

/// The smoothing kernels that a recipe has in closed form, in 1D, 2D and 3D; any other runs through the table.
template <class Line, class Plane, class Space>
using Curated = ByDimension<Union<Line, List<Tabulated>>, Union<Plane, List<Tabulated>>, Union<Space, List<Tabulated>>>;

// Leaner recipes are compiled in 2D and 3D, where time matters, for the kernels that are usual there: in closed form
// where the scheme has them.

/// A classic recipe without its viscosity, for where that is idle;
template <class Full, class Viscosity, class LeanKernels>
struct Inviscid : Without<Full, Viscosity> {
  using Kernels = LeanKernels;
};
/// and with a viscosity that Balsara's factor does not limit.
template <class Full, template <class> class Viscosity, class LeanKernels>
struct NoBalsara : Replacing<Full, Viscosity<BalsaraLimited>, Viscosity<Unlimited>> {
  using Kernels = LeanKernels;
};
template <class Full, template <class> class Viscosity, class LeanKernels>
using LeanClassic =
    List<Inviscid<Full, Viscosity<BalsaraLimited>, LeanKernels>, NoBalsara<Full, Viscosity, LeanKernels>>;

/// For kernels of leaner recipes: those that are usual go through the table.
using LeanThroughTable = ByDimension<List<>, List<Tabulated>, List<Tabulated>>;

/// What the density loop of the classic schemes adds up for Balsara's factor and the prediction of h.
using ClassicDensity = GradientSums;

}  // namespace sphk
