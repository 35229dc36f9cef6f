// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/terms/pressure_gradient_conservative.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

/// SPHS with the conservative momentum equation (S12 App. B).
struct SphsConservative {
  static constexpr SchemeFacts facts{.name = "sphs-conservative",
                                     .summary = "SPHS with the conservative momentum equation (S12 App. B)",
                                     .usual = wide_kernels,
                                     .steps = own_steps,
                                     .differs = "exact for any masses, where App. B takes equal ones"};

  struct Entropy : Recipe<EntropyForm, TermSet<>, SphsTerms<PressureGradientConservative>, SphsStep<GradH>> {
    using Kernels = Curated<List<>, List<>, List<Hoct<4>>>;
  };
  struct EqualEntropy : EqualMasses<Entropy> {
    using Kernels = Entropy::Kernels;
  };
  using Recipes = List<Entropy, EqualEntropy>;
};

}  // namespace sphk
