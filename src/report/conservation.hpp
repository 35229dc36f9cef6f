#pragma once

#include "src/engine/simulation.hpp"

namespace sphk {

/// Relative drift of the conserved sums since the start, all >= 0. Vectors are compared by the length of the
/// difference. A momentum or angular momentum that starts at zero has no scale of its own, so momentum is measured in
/// units of max(|p|, sqrt(2 M E)) of the start (sqrt(2 M E) bounds sum m |v| when all energy is kinetic) and angular
/// momentum in units of max(|L|, sqrt(2 M E) times the longest side of the box).
struct Conservation {
  double energy = 0, momentum = 0, angular_momentum = 0, mass = 0;
};

Conservation drift(const Totals& start, const Totals& now, const Box& box);

}  // namespace sphk
