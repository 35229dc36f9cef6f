// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/spacing_kernel.hpp"
#include "src/schemes/tsph.hpp"

namespace sphk {

/// TSPH with Monaghan's (2000) artificial pressure, the other cure of clumping, for comparison with R10's kernels.
struct TsphTensile {
  static constexpr SchemeFacts facts{.name = "tsph-tensile",
                                     .summary = "TSPH with an artificial pressure against clumping (Monaghan 2000)",
                                     .courant = 0.4};
  using Steps = Step<StateEquation, BalsaraFactor, NoBalsaraFactor, SpacingKernel>;

  struct Entropy
      : Recipe<EntropyForm, ClassicDensity,
               TermSet<PressureGradientTsph, TensileCorrection, ViscosityGingoldMonaghan<>, SignalVelocityMonaghan>,
               Steps> {
    using Kernels = Curated<List<>, List<>, List<>>;
  };
  struct Uncorrected : Without<Entropy, TensileCorrection> {
    using Kernels = LeanThroughTable;
  };
  using Recipes = Union<List<Entropy, Uncorrected>, LeanClassic<Entropy, ViscosityGingoldMonaghan, LeanThroughTable>>;
};

}  // namespace sphk
