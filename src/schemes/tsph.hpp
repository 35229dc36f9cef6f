// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/terms/pressure_gradient_tsph.hpp"
#include "kernels/terms/pressure_work.hpp"
#include "kernels/terms/viscosity_gingold_monaghan.hpp"
#include "src/schemes/step.hpp"

namespace sphk {

/// TSPH, R10 Table 2: phi = rho in the momentum equation.
struct Tsph {
  static constexpr SchemeFacts facts{.name = "tsph",
                                     .summary = "TSPH: phi = rho in the momentum equation (R10)",
                                     .courant = 0.4,
                                     .r10_label = "TSPH",
                                     .s12_label = "TSPH"};
  using Steps = Step<StateEquation, BalsaraFactor, NoBalsaraFactor>;

  struct Entropy : Recipe<EntropyForm, ClassicDensity,
                          TermSet<PressureGradientTsph, ViscosityGingoldMonaghan<>, SignalVelocityMonaghan>, Steps> {
    using Kernels = Curated<List<>, List<>, List<CoreTriangle, Hoct<4>>>;
  };
  struct Energy
      : Recipe<EnergyForm, ClassicDensity,
               TermSet<PressureGradientTsph, PressureWork, ViscosityGingoldMonaghan<>, SignalVelocityMonaghan>, Steps> {
    using Kernels = Curated<List<>, List<>, List<Hoct<4>>>;
  };
  using Lean = ByDimension<List<>, List<Tabulated>, List<Tabulated, Hoct<4>>>;
  using Recipes = Union<List<Entropy, Energy>, LeanClassic<Entropy, ViscosityGingoldMonaghan, Lean>,
                        LeanClassic<Energy, ViscosityGingoldMonaghan, LeanThroughTable>>;
};

}  // namespace sphk
