// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/sedov_solution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/engine/errors.hpp"
#include "src/engine/geometry.hpp"

namespace sphk {

namespace {
constexpr double log_step = 2.5e-4;
constexpr int steps = 32000;  // down to lambda = exp(-8) = 3.4e-4
}  // namespace

SedovSolution::SedovSolution(int dimension, double gamma) : dimension_(dimension), gamma_(gamma) {
  if (!(gamma > 1 && gamma < 7))
    throw InputError(fmt::format("the Sedov solution is known for gamma between 1 and 7, not for {}", gamma));
  integrate();
  const double delta = 2.0 / (dimension + 2);  // R ~ t^delta
  const double innermost = std::exp(-steps * log_step), rest = std::pow(innermost, dimension) / dimension;
  alpha_ = dimension * unit_sphere_volume(dimension) * delta * delta *
           (table_.back().energy + table_.back().Pi / (gamma - 1) * rest);
}

/// d/d(ln lambda) of the profiles. From the equations of continuity, motion and entropy with the form above, where R
/// d2R/dt2 = -D/2 (dR/dt)^2.
SedovSolution::Profile SedovSolution::slope(double log_lambda, const Profile& y) const {
  const double lambda = std::exp(log_lambda), D = dimension_, s = -D / 2, V = y.U - lambda;
  const double spread = (D - 1) * y.U / lambda;
  const double dU = (V * y.G * s * y.U - 2 * s * y.Pi - gamma_ * y.Pi * spread) / (gamma_ * y.Pi - y.G * V * V);
  const double dG = -y.G * (dU + spread) / V;
  const double dPi = -y.G * (s * y.U + V * dU);
  const double energy = (y.G * y.U * y.U / 2 + y.Pi / (gamma_ - 1)) * std::pow(lambda, D - 1);
  return {lambda * dG, lambda * dU, lambda * dPi, -lambda * energy};
}

/// Runge-Kutta inwards from the strong-shock jump at lambda = 1.
void SedovSolution::integrate() {
  const auto moved = [](const Profile& y, const Profile& k, double a) {
    return Profile{y.G + a * k.G, y.U + a * k.U, y.Pi + a * k.Pi, y.energy + a * k.energy};
  };
  Profile y{(gamma_ + 1) / (gamma_ - 1), 2 / (gamma_ + 1), 2 / (gamma_ + 1), 0};
  table_.push_back(y);
  const double d = -log_step;
  for (int k = 0; k < steps; ++k) {
    const double at = k * d;
    const Profile k1 = slope(at, y), k2 = slope(at + d / 2, moved(y, k1, d / 2));
    const Profile k3 = slope(at + d / 2, moved(y, k2, d / 2)), k4 = slope(at + d, moved(y, k3, d));
    y = moved(moved(moved(moved(y, k1, d / 6), k2, d / 3), k3, d / 3), k4, d / 6);
    table_.push_back(y);
  }
}

double SedovSolution::shock_radius(double E, double rho_0, double t) const {
  return std::pow(E * t * t / (alpha_ * rho_0), 1.0 / (dimension_ + 2));
}

GasState SedovSolution::behind_shock(double r, double E, double rho_0, double t) const {
  const double R = shock_radius(E, rho_0, t), shock_speed = 2 * R / ((dimension_ + 2) * t);
  const double place = std::clamp(-std::log(r / R) / log_step, 0.0, double(steps) * (1 - 1e-12));
  const auto k = static_cast<std::size_t>(place);
  const double b = place - double(k), a = 1 - b;
  const Profile &outer = table_[k], &inner = table_[k + 1];
  const double lambda_U = place < steps - 1 ? a * outer.U + b * inner.U : inner.U * r / R * std::exp(steps * log_step);
  return {rho_0 * (a * outer.G + b * inner.G),
          {shock_speed * lambda_U, 0, 0},
          rho_0 * shock_speed * shock_speed * (a * outer.Pi + b * inner.Pi)};
}

}  // namespace sphk
