// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/riemann.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/engine/errors.hpp"

namespace sphk {
namespace {

/// A tube with published values: Toro 2009, table 4.3 (four to six figures, some cut off instead of rounded), and the
/// tubes of S12, R10 and V10 as another program computed them, to the digits given.
struct Published {
  const char* name;
  TubeState left, right;
  double gamma, P_star, v_star, rho_left, rho_right, tolerance;
};
const Published tubes[] = {
    {"Sod 5/3", {1, 0, 1}, {0.125, 0, 0.1}, 5.0 / 3, 0.293945, 0.841195, 0.479689, 0.229806, 1e-6},
    {"Sod 1.4", {1, 0, 1}, {0.125, 0, 0.1}, 1.4, 0.30313, 0.92745, 0.42632, 0.26557, 6e-6},
    {"V10", {1, 0, 1}, {0.25, 0, 1.0 / 6}, 5.0 / 3, 0.41157, 0.63008, 0.58704, 0.42035, 6e-6},
    {"Toro 2", {1, -2, 0.4}, {1, 2, 0.4}, 1.4, 0.00189, 0, 0.02185, 0.02185, 6e-6},
    {"Toro 3", {1, 0, 1000}, {1, 0, 0.01}, 1.4, 460.894, 19.5975, 0.57506, 5.99924, 6e-4},
    {"Toro 4", {1, 0, 0.01}, {1, 0, 100}, 1.4, 46.0950, -6.19633, 5.99242, 0.57511, 6e-5},
    {"Toro 5",
     {5.99924, 19.5975, 460.894},
     {5.99242, -6.19633, 46.0950},
     1.4,
     1691.64,
     8.68975,
     14.2823,
     31.0426,
     1e-2},
};

TEST(Riemann, EqualsPublishedSolutions) {
  for (const Published& tube : tubes) {
    const RiemannSolution solution(tube.left, tube.right, tube.gamma);
    EXPECT_NEAR(solution.P_star(), tube.P_star, tube.tolerance) << tube.name;
    EXPECT_NEAR(solution.v_star(), tube.v_star, tube.tolerance) << tube.name;
    EXPECT_NEAR(solution.rho_star_left(), tube.rho_left, tube.tolerance) << tube.name;
    EXPECT_NEAR(solution.rho_star_right(), tube.rho_right, tube.tolerance) << tube.name;
  }
}

TEST(Riemann, HasTheShockSpeedsOfTheTubes) {
  const double expected[] = {1.84447, 1.75216, 1.55476};
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(RiemannSolution(tubes[k].left, tubes[k].right, tubes[k].gamma).right_front(), expected[k], 6e-6);
}

/// The largest relative defect of the three conservation laws over a jump that moves with speed S, in its own frame,
/// where mass, momentum and energy flow at rho w, rho w^2 + P and (rho w^2/2 + gamma P/(gamma-1)) w.
double jump_defect(const TubeState& a, const TubeState& b, double S, double gamma) {
  const auto fluxes = [&](const TubeState& s) {
    const double w = s.v - S;
    return std::array{s.rho * w, s.rho * w * w + s.P, (s.rho * w * w / 2 + gamma * s.P / (gamma - 1)) * w};
  };
  const auto f = fluxes(a), g = fluxes(b);
  double worst = 0;
  for (int k = 0; k < 3; ++k) worst = std::max(worst, std::abs(f[k] - g[k]) / (std::abs(f[k]) + std::abs(g[k])));
  return worst;
}

/// The largest relative change over a rarefaction of the invariants v -+ 2c/(gamma-1) and P/rho^gamma; the direction is
/// -1 for the left wave.
double invariant_defect(const TubeState& a, const TubeState& b, double direction, double gamma) {
  const auto invariants = [&](const TubeState& s) {
    const double c = std::sqrt(gamma * s.P / s.rho);
    return std::array{s.v - direction * 2 * c / (gamma - 1), s.P / std::pow(s.rho, gamma)};
  };
  const auto f = invariants(a), g = invariants(b);
  return std::max(std::abs(f[0] - g[0]) / (std::abs(f[0]) + 1), std::abs(f[1] / g[1] - 1));
}

double wave_defect(const RiemannSolution& solution, const TubeState& outside, const TubeState& star, double front,
                   double direction, double gamma) {
  return solution.P_star() > outside.P ? jump_defect(outside, star, front, gamma)
                                       : invariant_defect(outside, star, direction, gamma);
}

// Independent of how the solver works: Rankine-Hugoniot over shocks, Riemann invariants over rarefactions.
TEST(Riemann, WavesObeyTheJumpConditionsAndTheInvariants) {
  for (const Published& tube : tubes) {
    const double g = tube.gamma;
    const RiemannSolution s(tube.left, tube.right, g);
    const TubeState left{s.rho_star_left(), s.v_star(), s.P_star()}, right{s.rho_star_right(), s.v_star(), s.P_star()};
    EXPECT_LT(wave_defect(s, tube.left, left, s.left_front(), -1, g), 1e-12) << tube.name;
    EXPECT_LT(wave_defect(s, tube.right, right, s.right_front(), 1, g), 1e-12) << tube.name;
  }
}

// Inside a left fan: x/t = v - c, with the invariants of the state on the left.
TEST(Riemann, FansAreSelfSimilar) {
  for (const Published& tube : {tubes[0], tubes[1], tubes[2], tubes[3]}) {
    const RiemannSolution s(tube.left, tube.right, tube.gamma);
    const double tail = s.v_star() - std::sqrt(tube.gamma * s.P_star() / s.rho_star_left());
    for (double part = 0.1; part < 1; part += 0.2) {
      const double xi = s.left_front() + part * (tail - s.left_front());
      const TubeState state = s.at(xi);
      EXPECT_NEAR(state.v - std::sqrt(tube.gamma * state.P / state.rho), xi, 1e-12) << tube.name;
      EXPECT_LT(invariant_defect(tube.left, state, -1, tube.gamma), 1e-12) << tube.name;
    }
  }
}

// A tube seen in a mirror has the mirrored solution.
TEST(Riemann, IsSymmetricUnderReflection) {
  for (const Published& tube : tubes) {
    const auto mirror = [](TubeState s) { return TubeState{s.rho, -s.v, s.P}; };
    const RiemannSolution s(tube.left, tube.right, tube.gamma), m(mirror(tube.right), mirror(tube.left), tube.gamma);
    for (double xi = -3.03; xi < 3; xi += 0.1) {
      EXPECT_NEAR(s.at(xi).rho, m.at(-xi).rho, 1e-12 * s.at(xi).rho) << tube.name << ' ' << xi;
      EXPECT_NEAR(s.at(xi).v, -m.at(-xi).v, 1e-12 * 20) << tube.name << ' ' << xi;
    }
  }
}

TEST(Riemann, MovesWithTheFrame) {
  const double boost = 3.7;
  const RiemannSolution rest({1, 0, 1}, {0.125, 0, 0.1}, 1.4), moving({1, boost, 1}, {0.125, boost, 0.1}, 1.4);
  for (double xi = -1.5; xi < 2; xi += 0.07) {
    EXPECT_NEAR(moving.at(xi + boost).P, rest.at(xi).P, 1e-12) << xi;
    EXPECT_NEAR(moving.at(xi + boost).v, rest.at(xi).v + boost, 1e-12) << xi;
  }
}

TEST(Riemann, RefusesVacuumAndBadStates) {
  EXPECT_THROW(RiemannSolution({1, -6, 0.4}, {1, 6, 0.4}, 1.4), InputError);  // 12 > 2/(0.4) * 2 * 0.748 = 7.5
  EXPECT_NO_THROW(RiemannSolution({1, -3.7, 0.4}, {1, 3.7, 0.4}, 1.4));
  EXPECT_THROW(RiemannSolution({0, 0, 1}, {1, 0, 1}, 1.4), InputError);
  EXPECT_THROW(RiemannSolution({1, 0, 1}, {1, 0, -1}, 1.4), InputError);
}

}  // namespace
}  // namespace sphk
