// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/riemann.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/engine/errors.hpp"

namespace sphk {

RiemannSolution::RiemannSolution(const TubeState& left, const TubeState& right, double gamma) : gamma_(gamma) {
  for (const TubeState& state : {left, right})
    if (!(state.rho > 0 && state.P > 0))
      throw InputError(
          fmt::format("a shock tube needs positive densities and pressures, not rho = {}, P = {}", state.rho, state.P));
  left_ = {left, -1, std::sqrt(gamma * left.P / left.rho)};
  right_ = {right, 1, std::sqrt(gamma * right.P / right.rho)};
  if (2 / (gamma - 1) * (left_.c + right_.c) <= right.v - left.v)
    throw InputError(
        fmt::format("the two halves of the shock tube part at {}, which opens a vacuum between them; it "
                    "must be less than 2 (c_left + c_right) / (gamma - 1) = {}",
                    right.v - left.v, 2 / (gamma - 1) * (left_.c + right_.c)));
  P_star_ = solve_P_star();
  double unused = 0;
  v_star_ = (left.v + right.v + velocity_change(right_, P_star_, unused) - velocity_change(left_, P_star_, unused)) / 2;
}

/// f_K(P) and its derivative, Toro eq 4.6, 4.7 and 4.37: the velocity that the side's wave takes the gas through.
double RiemannSolution::velocity_change(const Side& side, double P, double& slope) const {
  const auto& [rho, v, P0] = side.state;
  if (P > P0) {
    const double A = 2 / ((gamma_ + 1) * rho), B = (gamma_ - 1) / (gamma_ + 1) * P0;
    const double root = std::sqrt(A / (P + B));
    slope = root * (1 - (P - P0) / (2 * (B + P)));
    return (P - P0) * root;
  }
  slope = std::pow(P / P0, -(gamma_ + 1) / (2 * gamma_)) / (rho * side.c);
  return 2 * side.c / (gamma_ - 1) * std::expm1((gamma_ - 1) / (2 * gamma_) * std::log(P / P0));
}

/// Newton's method on f_L + f_R + v_R - v_L = 0, which rises and is concave: from the left it never overshoots. The
/// two-rarefaction pressure, Toro eq 4.46, is where it starts.
double RiemannSolution::solve_P_star() const {
  const double z = (gamma_ - 1) / (2 * gamma_), dv = right_.state.v - left_.state.v;
  double P = std::pow((left_.c + right_.c - (gamma_ - 1) / 2 * dv) /
                          (left_.c / std::pow(left_.state.P, z) + right_.c / std::pow(right_.state.P, z)),
                      1 / z);
  for (int iteration = 0; iteration < 100; ++iteration) {
    double slope_left = 0, slope_right = 0;
    const double f = velocity_change(left_, P, slope_left) + velocity_change(right_, P, slope_right) + dv;
    const double next = std::max(P - f / (slope_left + slope_right), P / 10);
    const bool done = std::abs(next - P) <= 1e-15 * P;
    P = next;
    if (done) break;
  }
  return P;
}

/// Density between the side's wave and the contact: Hugoniot (Toro eq 4.50) or isentrope (eq 4.53).
double RiemannSolution::rho_star(const Side& side) const {
  const double ratio = P_star_ / side.state.P, g = (gamma_ - 1) / (gamma_ + 1);
  return side.state.rho * (ratio > 1 ? (ratio + g) / (g * ratio + 1) : std::pow(ratio, 1 / gamma_));
}

/// Speed of the side's outermost wave: shock (Toro eq 4.52, 4.59) or rarefaction head.
double RiemannSolution::front(const Side& side) const {
  const double ratio = P_star_ / side.state.P;
  const double mach = ratio > 1 ? std::sqrt(((gamma_ + 1) * ratio + gamma_ - 1) / (2 * gamma_)) : 1;
  return side.state.v + side.direction * side.c * mach;
}

/// The state on a ray on this side of the contact.
TubeState RiemannSolution::behind(const Side& side, double xi) const {
  const double s = side.direction;
  if (s * xi >= s * front(side)) return side.state;
  const TubeState star{rho_star(side), v_star_, P_star_};
  const double tail = v_star_ + s * std::sqrt(gamma_ * P_star_ / star.rho);
  if (P_star_ > side.state.P || s * xi <= s * tail) return star;
  // Inside the fan, Toro eq 4.56 and 4.63.
  const double v = 2 / (gamma_ + 1) * (-s * side.c + (gamma_ - 1) / 2 * side.state.v + xi);
  const double c = s * (xi - v);
  const double rho = side.state.rho * std::pow(c / side.c, 2 / (gamma_ - 1));
  return {rho, v, side.state.P * std::pow(c / side.c, 2 * gamma_ / (gamma_ - 1))};
}

TubeState RiemannSolution::at(double xi) const {
  return behind(xi < v_star_ ? left_ : right_, xi);
}

}  // namespace sphk
