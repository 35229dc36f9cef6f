// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/general_density.hpp"
#include "kernels/terms/pressure_gradient_general.hpp"
#include "kernels/terms/viscosity_gingold_monaghan.hpp"
#include "src/schemes/step.hpp"

namespace sphk {

/// A step of the schemes with a generalised continuity equation.
template <class Continuity, class Functions>
using GeneralStep = Step<Continuity, EquationOfState<GeneralDensity>, BalsaraFactor, NoBalsaraFactor, Functions>;

/// The generalised family of R10 eq 16-19: any eta, phi and zeta, types such as those of free_functions.hpp. With A
/// integrated zeta plays no part.
template <class Eta, class Phi>
using EntropyFamily = Recipe<EntropyForm, ClassicDensity,
                             TermSet<PressureGradientGeneral<Phi>, ViscosityGingoldMonaghan<>, SignalVelocityMonaghan>,
                             GeneralStep<GeneralContinuity<Eta>, FreeFunctions<Phi, One>>>;
template <class Eta, class Phi, class Zeta>
using EnergyFamily = Recipe<
    EnergyForm, ClassicDensity,
    TermSet<PressureGradientGeneral<Phi>, PressureWorkGeneral, ViscosityGingoldMonaghan<>, SignalVelocityMonaghan>,
    GeneralStep<GeneralContinuity<Eta>, FreeFunctions<Phi, Zeta>>>;

/// OSPH, R10 Table 2.
struct Osph {
  static constexpr SchemeFacts facts{.name = "osph",
                                     .summary = "OSPH: pressures of the generalised density (R10)",
                                     .usual = wide_kernels,
                                     .courant = 0.4,
                                     .r10_label = "OSPH",
                                     .s12_label = "OSPH"};

  struct Entropy : EntropyFamily<InverseEntropyRoot, DensityItself> {
    using Kernels = Curated<List<>, List<>, List<Hoct<4>>>;
  };
  struct Energy : EnergyFamily<InverseEnergy, DensityItself, InverseEnergy> {
    using Kernels = Curated<List<>, List<>, List<Hoct<4>>>;
  };
  using Lean = ByDimension<List<>, List<Tabulated>, List<Hoct<4>>>;
  using Recipes = Union<List<Entropy, Energy>, LeanClassic<Entropy, ViscosityGingoldMonaghan, Lean>,
                        LeanClassic<Energy, ViscosityGingoldMonaghan, Lean>>;
};

}  // namespace sphk
