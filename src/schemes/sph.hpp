// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/terms/pressure_gradient_sph.hpp"
#include "kernels/terms/pressure_work.hpp"
#include "kernels/terms/viscosity_gingold_monaghan.hpp"
#include "src/schemes/step.hpp"

namespace sphk {

/// SPH as in R10: no grad-h, Gingold & Monaghan's viscosity with the Balsara switch.
struct Sph {
  static constexpr SchemeFacts facts{.name = "sph",
                                     .summary = "SPH as in R10: no grad-h, Gingold & Monaghan's viscosity",
                                     .courant = 0.4,
                                     .r10_label = "SPH"};
  using Steps = Step<StateEquation, BalsaraFactor, NoBalsaraFactor>;

  struct Entropy : Recipe<EntropyForm, ClassicDensity,
                          TermSet<PressureGradientSph, ViscosityGingoldMonaghan<>, SignalVelocityMonaghan>, Steps> {
    using Kernels = Curated<List<>, List<CubicSpline>, List<CubicSpline, Hoct<4>>>;
  };
  struct Energy
      : Recipe<EnergyForm, ClassicDensity,
               TermSet<PressureGradientSph, PressureWork, ViscosityGingoldMonaghan<>, SignalVelocityMonaghan>, Steps> {
    using Kernels = Curated<List<>, List<>, List<>>;
  };
  using Lean = ByDimension<List<>, List<CubicSpline>, List<CubicSpline>>;
  using Recipes = Union<List<Entropy, Energy>, LeanClassic<Entropy, ViscosityGingoldMonaghan, Lean>,
                        LeanClassic<Energy, ViscosityGingoldMonaghan, LeanThroughTable>>;
};

}  // namespace sphk
