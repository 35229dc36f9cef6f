// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/general_density.hpp"
#include "kernels/terms/artificial_conductivity.hpp"
#include "kernels/terms/pressure_gradient_conservative.hpp"
#include "kernels/terms/signal_velocity.hpp"
#include "kernels/terms/viscosity_valcke.hpp"
#include "src/schemes/step.hpp"

namespace sphk {

/// Terms of V10's scheme with a conductivity.
template <class Conductivity>
using V10Terms = TermSet<PressureGradientConservative, ViscosityValcke<>, Conductivity, SignalVelocity>;
/// Its step; passes of a conductivity before the rates.
template <class... BeforeRates>
using V10Step = Step<StateEquation, BalsaraFactor, NoBalsaraFactor, GradH, BeforeRates...>;

/// GADGET-2's scheme with V10's viscosity and artificial conductivity (V10 sec 2).
struct V10 {
  static constexpr SchemeFacts facts{
      .name = "v10", .summary = "GADGET-2's scheme with artificial conductivity (Valcke et al. 2010, V10)"};

  struct Entropy : Recipe<EntropyForm, ClassicDensity, V10Terms<ArtificialConductivity>, V10Step<>> {
    using Kernels = Curated<List<>, List<CubicSpline, Liq>, List<>>;
  };
  /// With the signal velocity of smoothed pressures (V10 eq 6).
  struct Smoothed
      : Recipe<EntropyForm, ClassicDensity, V10Terms<ArtificialConductivitySmoothed>, V10Step<SmoothedPressures>> {
    using Kernels = Curated<List<>, List<>, List<>>;
  };
  /// Without conductivity (V10's series NOAC).
  struct Plain : Without<Entropy, ArtificialConductivity> {
    using Kernels = Entropy::Kernels;
  };
  using Lean = ByDimension<List<>, List<CubicSpline>, List<Tabulated>>;
  using Recipes = Union<List<Entropy, Smoothed, Plain>, LeanClassic<Entropy, ViscosityValcke, Lean>,
                        LeanClassic<Plain, ViscosityValcke, Lean>>;
};

}  // namespace sphk
