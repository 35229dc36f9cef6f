// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

namespace sphk {

/// The mass of gas whose density rho(y) is given, from one end of an interval to y, and its inverse: rows of particles
/// at equal steps of mass follow the density.
class MassProfile {
 public:
  /// On [lower, lower + size], by the midpoint rule. Jumps of rho at multiples of size/cells cost no accuracy.
  MassProfile(const std::function<double(double y)>& rho, double lower, double size, int cells = 16384);

  /// Integral of rho over the interval.
  double mass() const { return below_.back(); }
  /// The y below which this fraction (0 to 1) of the mass lies.
  double place(double fraction) const;

 private:
  double lower_, step_;
  std::vector<double> below_;  ///< mass below lower + k step
};

}  // namespace sphk
