// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/terms/entropy_dissipation.hpp"
#include "kernels/terms/mass_dissipation.hpp"
#include "kernels/terms/pressure_gradient_tsph.hpp"
#include "kernels/terms/pressure_work_tsph.hpp"
#include "kernels/terms/signal_velocity.hpp"
#include "kernels/terms/viscosity_switched.hpp"
#include "src/schemes/step.hpp"

namespace sphk {

/// A step of SPHS; passes of a pressure or momentum equation before the gradients.
template <class... BeforeGradients>
using SphsStep = typename Before<StateEquation, BeforeGradients..., Gradients, ConvergenceSwitch,
                                 GivenAlpha>::template Then<MassExchange>;
/// Terms of SPHS: a momentum equation with what pays for its work, and the dissipations.
template <class... Pressure>
using SphsTerms = TermSet<Pressure..., ViscositySwitched<>, EntropyDissipation<>, MassDissipation, SignalVelocity>;
/// Equal masses and a step without a switch.
template <class Form, class... Terms>
using Unswitched = Recipe<Form, DivergenceSum, TermSet<Terms..., SignalVelocity>, Step<StateEquation>>;

/// A recipe of SPHS for equal masses.
template <class Full>
using EqualMasses = Without<Full, MassDissipation>;
/// Kernels of the leaner recipes.
using SphsLeanKernels = ByDimension<List<>, List<WendlandC6>, List<Hoct<4>>>;

/// SPHS (Read & Hayfield 2012, S12): the switch of the fitted velocity gradients drives every dissipation.
struct Sphs {
  static constexpr SchemeFacts facts{
      .name = "sphs",
      .summary = "SPHS: fitted gradients, a switch and three dissipations (Read & Hayfield 2012, S12)",
      .usual = wide_kernels,
      .steps = own_steps,
      .mixing_energy = "energy",
      .s12_label = "SPHS"};
  using Wide = Curated<List<>, List<Hoct<4>, WendlandC6>, List<Hoct<4>>>;

  struct Entropy : Recipe<EntropyForm, TermSet<>, SphsTerms<PressureGradientTsph>, SphsStep<>> {
    using Kernels = Wide;
  };
  /// With u in place of A: eq 7 conserves energy with the work that it does, not with a constant A.
  struct Energy : Recipe<EnergyForm, TermSet<>, SphsTerms<PressureGradientTsph, PressureWorkTsph>, SphsStep<>> {
    using Kernels = Wide;
  };
  struct EqualEntropy : EqualMasses<Entropy> {
    using Kernels = Curated<List<>, List<Hoct<4>, WendlandC6>, List<Hoct<4>, WendlandC2, BSpline<5>, Liq>>;
  };
  struct EqualEnergy : EqualMasses<Energy> {
    using Kernels = Wide;
  };
  template <class Full>
  struct Inviscid : Without<Full, MassDissipation, ViscositySwitched<>> {
    using Kernels = SphsLeanKernels;
  };
  template <class Full>
  struct Isentropic : Without<Full, MassDissipation, EntropyDissipation<>> {
    using Kernels = SphsLeanKernels;
  };
  /// The same alpha for every particle.
  template <class Form, class... Pressure>
  struct OneAlpha : Unswitched<Form, Pressure..., ViscositySwitched<ConstantAlpha>, EntropyDissipation<ConstantAlpha>> {
    using Kernels = SphsLeanKernels;
    using LeftOut = List<MassDissipation>;
    static constexpr bool lean = true;
  };
  /// No dissipation at all.
  template <class Form, class... Pressure>
  struct Ideal : Unswitched<Form, Pressure...> {
    using Kernels = SphsLeanKernels;
    using LeftOut = List<MassDissipation, ViscositySwitched<>, EntropyDissipation<>>;
    static constexpr bool lean = true;
  };
  using Recipes =
      List<Entropy, Energy, EqualEntropy, EqualEnergy, Inviscid<Entropy>, Inviscid<Energy>, Isentropic<Entropy>,
           Isentropic<Energy>, OneAlpha<EntropyForm, PressureGradientTsph>,
           OneAlpha<EnergyForm, PressureGradientTsph, PressureWorkTsph>, Ideal<EntropyForm, PressureGradientTsph>,
           Ideal<EnergyForm, PressureGradientTsph, PressureWorkTsph>>;
};

}  // namespace sphk
