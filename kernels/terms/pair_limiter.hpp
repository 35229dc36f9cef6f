// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/terms/term_set.hpp"

namespace sphk {

/// Balsara's factor limits the viscosity of classic schemes, or does not.
inline constexpr Number viscosity_balsara{.key = "viscosity.balsara",
                                          .standard = 1,
                                          .meaning = "Balsara's factor limits the viscosity (S12 eq 32)",
                                          .max = 1,
                                          .words = off_or_on};

// What limits the viscosity of a pair: Limiter::sum is twice the mean of a factor.

struct BalsaraLimited {
  using Reads = List<Balsara>;
  KOKKOS_FORCEINLINE_FUNCTION static auto sum(const auto& i, const auto& j) { return i.balsara + j.balsara; }
};

struct Unlimited {
  using Reads = List<>;
  static bool serves(const Given& given) { return given[viscosity_balsara] == 0; }
  KOKKOS_FORCEINLINE_FUNCTION static auto sum(const auto& i, const auto&) {
    using P = std::remove_cvref_t<decltype(i.m)>;
    return P(lane_t<P>(2));
  }
};

}  // namespace sphk
