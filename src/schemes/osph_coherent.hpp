// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/terms/pressure_gradient_coherent.hpp"
#include "src/schemes/osph.hpp"

namespace sphk {

/// Pseudo-coherent OSPH with grad-h (R10 footnote 4): eta = phi = zeta, which conserves energy.
struct OsphCoherent {
  static constexpr SchemeFacts facts{
      .name = "osph-coherent",
      .summary = "OSPH with grad-h and eta = phi = zeta, which conserves energy (R10 footnote 4)",
      .usual = wide_kernels,
      .courant = 0.4};

  struct Entropy
      : Recipe<
            EntropyForm, ClassicDensity,
            TermSet<PressureGradientCoherent<InverseEntropyRoot>, ViscosityGingoldMonaghan<>, SignalVelocityMonaghan>,
            GeneralStep<CoherentContinuity<InverseEntropyRoot>,
                        FreeFunctions<InverseEntropyRoot, InverseEntropyRoot>>> {
    using Kernels = Curated<List<>, List<>, List<>>;
  };
  struct Energy : Recipe<EnergyForm, ClassicDensity,
                         TermSet<PressureGradientCoherent<InverseEnergy>, PressureWorkCoherent,
                                 ViscosityGingoldMonaghan<>, SignalVelocityMonaghan>,
                         GeneralStep<CoherentContinuity<InverseEnergy>, FreeFunctions<InverseEnergy, InverseEnergy>>> {
    using Kernels = Curated<List<>, List<>, List<>>;
  };
  using Recipes = Union<List<Entropy, Energy>, LeanClassic<Entropy, ViscosityGingoldMonaghan, LeanThroughTable>,
                        LeanClassic<Energy, ViscosityGingoldMonaghan, LeanThroughTable>>;
};

}  // namespace sphk
