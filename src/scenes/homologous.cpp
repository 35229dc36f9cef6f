// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/homologous.hpp"

#include <cmath>

#include "src/scenes/norms.hpp"

namespace sphk {

double HomologousExpansion::outer_radius(double t) const {
  const auto acceleration = [&](double R) { return 2 / (gamma_ - 1) * std::pow(R, -1 - dimension_ * (gamma_ - 1)); };
  constexpr int steps = 4000;
  const double dt = t / steps;
  double R = 1, V = 0;
  for (int k = 0; k < steps; ++k) {
    const double V1 = V, a1 = acceleration(R);
    const double V2 = V + dt / 2 * a1, a2 = acceleration(R + dt / 2 * V1);
    const double V3 = V + dt / 2 * a2, a3 = acceleration(R + dt / 2 * V2);
    const double V4 = V + dt * a3, a4 = acceleration(R + dt * V3);
    R += dt / 6 * (V1 + 2 * V2 + 2 * V3 + V4);
    V += dt / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return R;
}

double HomologousExpansion::outer_speed(double R) const {
  return 2 / (gamma_ - 1) * std::sqrt((1 - std::pow(R, -dimension_ * (gamma_ - 1))) / dimension_);
}

GasState HomologousExpansion::at(const Array3& x, double R) const {
  const double f = 1 - std::pow(radius(x) / R, 2), rate = outer_speed(R) / R;
  if (f <= 0) return {0, {}, 0};
  const double rho = std::pow(R, -dimension_) * std::pow(f, 1 / (gamma_ - 1));
  return {rho, {rate * x[0], rate * x[1], rate * x[2]}, std::pow(rho, gamma_) / gamma_};
}

}  // namespace sphk
