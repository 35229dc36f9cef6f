// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/schemes/v10.hpp"

namespace sphk {

/// V10 with u integrated and no work done on it: what relaxes an initial condition (V10 sec 4.5.1).
struct Relaxation {
  static constexpr SchemeFacts facts{
      .name = "relaxation", .summary = "settles an initial condition (V10 sec 4.5.1)", .hidden = true};

  struct Energy : Recipe<EnergyForm, ClassicDensity, V10Terms<ArtificialConductivity>, V10Step<>> {
    using Kernels = Curated<List<>, List<>, List<>>;
  };
  using Recipes = List<Energy>;
};

}  // namespace sphk
