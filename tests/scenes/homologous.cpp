// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/homologous.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sphk {
namespace {

// R^2 = 1 + 2/(gamma-1) t^2 where D (gamma-1) = 2: gamma 5/3 in 3D, 2 in 2D, 3 in 1D.
TEST(HomologousExpansion, HasItsClosedForm) {
  for (int D = 1; D <= 3; ++D) {
    const double gamma = 1 + 2.0 / D;
    const HomologousExpansion expansion(D, gamma);
    for (const double t : {0.0, 0.1, 1.0, 3.0})
      EXPECT_NEAR(expansion.outer_radius(t), std::sqrt(1 + 2 / (gamma - 1) * t * t), 1e-12) << D << ' ' << t;
  }
}

// dR/dt by central differences of R(t) is what the energy integral gives. Over 2e-4 they leave 1e-8/6 of the third
// derivative, which is of order 10, and 1e-12/1e-4 of rounding.
TEST(HomologousExpansion, ConservesEnergy) {
  for (int D = 1; D <= 3; ++D)
    for (const double gamma : {1.4, 5.0 / 3})
      for (const double t : {0.3, 1.0, 2.5}) {
        const HomologousExpansion expansion(D, gamma);
        const double speed = (expansion.outer_radius(t + 1e-4) - expansion.outer_radius(t - 1e-4)) / 2e-4;
        EXPECT_NEAR(expansion.outer_speed(expansion.outer_radius(t)), speed, 1e-7) << D << ' ' << gamma << ' ' << t;
      }
}

// Euler's equations of a radial flow, by central differences in r and t:
//   d rho/dt + r^(1-D) d(r^(D-1) rho v)/dr = 0,  dv/dt + v dv/dr + (1/rho) dP/dr = 0.
TEST(HomologousExpansion, SolvesEulersEquations) {
  constexpr double d = 1e-4;
  for (int D = 1; D <= 3; ++D) {
    const HomologousExpansion expansion(D, 1.4);
    const auto state = [&](double r, double t) { return expansion.at({r, 0, 0}, expansion.outer_radius(t)); };
    const auto flux = [&](double r, double t) { return std::pow(r, D - 1) * state(r, t).rho * state(r, t).v[0]; };
    for (const double t : {0.4, 1.5})
      for (const double share : {0.2, 0.6, 0.9}) {
        const double r = share * expansion.outer_radius(t);
        const GasState here = state(r, t);
        const double rho_t = (state(r, t + d).rho - state(r, t - d).rho) / (2 * d);
        EXPECT_NEAR(rho_t + (flux(r + d, t) - flux(r - d, t)) / (2 * d) * std::pow(r, 1 - D), 0, 1e-6) << D;
        const double v_t = (state(r, t + d).v[0] - state(r, t - d).v[0]) / (2 * d);
        const double v_r = (state(r + d, t).v[0] - state(r - d, t).v[0]) / (2 * d);
        const double P_r = (state(r + d, t).P - state(r - d, t).P) / (2 * d);
        EXPECT_NEAR(v_t + here.v[0] * v_r + P_r / here.rho, 0, 1e-6) << D << ' ' << t << ' ' << share;
      }
    EXPECT_EQ(state(1.001 * expansion.outer_radius(1), 1).rho, 0);
  }
}

}  // namespace
}  // namespace sphk
