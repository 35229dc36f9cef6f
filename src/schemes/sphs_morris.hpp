// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/schemes/sphs.hpp"

namespace sphk {

/// SPHS with E0 subtracted from the pressure force (S12 eq 18, suffix e).
struct SphsMorris {
  static constexpr SchemeFacts facts{.name = "sphs-morris",
                                     .summary = "SPHS with E0 subtracted from the pressure force (S12 eq 18)",
                                     .usual = wide_kernels,
                                     .steps = own_steps,
                                     .s12_label = "SPHS",
                                     .label_suffix = "e"};

  struct Entropy : Recipe<EntropyForm, TermSet<>, SphsTerms<PressureGradientMorris>, SphsStep<>> {
    using Kernels = Curated<List<>, List<>, List<Hoct<4>>>;
  };
  struct EqualEntropy : EqualMasses<Entropy> {
    using Kernels = Curated<List<>, List<WendlandC6>, List<Hoct<4>, WendlandC2, BSpline<5>, Liq>>;
  };
  using Recipes = List<Entropy, EqualEntropy>;
};

}  // namespace sphk
