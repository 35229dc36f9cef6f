// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "src/engine/simulation.hpp"

namespace sphk {

/// Drift of the conserved sums since the start, all >= 0. Vectors are compared by the length of the difference.
/// Energy is relative to kinetic + thermal + |potential| of the start, momentum to sum m |v|, angular momentum to
/// sum m |x cross v|, then or now, whichever is larger: sums that cancel have a scale too. In gas without motion what
/// floats leave is no drift: the scale is at least 1e-6 of that of its heat, sqrt(2 M E) and, about the origin, sqrt(2
/// M E) times the longest side of the box.
struct Conservation {
  double energy = 0, momentum = 0, angular_momentum = 0, mass = 0;
  /// Relative to the sum at the start (S12 Fig. 10), where that is not zero.
  std::optional<double> momentum_of_start, angular_momentum_of_start;
};

Conservation drift(const Totals& start, const Totals& now, const Box& box);

}  // namespace sphk
