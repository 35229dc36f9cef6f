// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/mass_profile.hpp"

#include <algorithm>

namespace sphk {

MassProfile::MassProfile(const std::function<double(double y)>& rho, double lower, double size, int cells)
    : lower_(lower), step_(size / cells), below_(cells + 1) {
  for (int k = 0; k < cells; ++k) below_[k + 1] = below_[k] + rho(lower + (k + 0.5) * step_) * step_;
}

double MassProfile::place(double fraction) const {
  const double wanted = fraction * mass();
  const auto above = std::upper_bound(below_.begin() + 1, below_.end() - 1, wanted);
  const double here = *(above - 1), share = (wanted - here) / (*above - here);
  return lower_ + (static_cast<double>(above - 1 - below_.begin()) + share) * step_;
}

}  // namespace sphk
