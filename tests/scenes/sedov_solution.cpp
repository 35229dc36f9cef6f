// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/sedov_solution.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/engine/errors.hpp"

namespace sphk {
namespace {

// S12 eq 47 prints 1.15 for gamma 5/3.
TEST(SedovSolution, HasItsShockRadius) {
  const SedovSolution solution(3, 5.0 / 3);
  EXPECT_NEAR(solution.shock_radius(1, 1, 1), 1.15, 0.005);
  EXPECT_NEAR(solution.shock_radius(3, 2, 0.5) / solution.shock_radius(1, 1, 1), std::pow(3 * 0.25 / 2, 0.2), 1e-14);
}

// Strong shock: rho = (gamma+1)/(gamma-1) rho_0, v = 2/(gamma+1) dR/dt, P = 2/(gamma+1) rho_0 (dR/dt)^2, and dR/dt is
// 2R/(5t).
TEST(SedovSolution, ObeysTheJumpConditions) {
  const double E = 1, rho = 1, t = 0.05;
  const SedovSolution solution(3, 5.0 / 3);
  const double R = solution.shock_radius(E, rho, t), speed = 2 * R / (5 * t);
  const GasState state = solution.behind_shock(R, E, rho, t);
  EXPECT_NEAR(state.rho, 4, 1e-9);
  EXPECT_NEAR(state.v[0], 0.75 * speed, 1e-9);
  EXPECT_NEAR(state.P, 0.75 * speed * speed, 1e-8);
}

/// Sedov's closed form for an even gas, from Kamm & Timmes (2007) with omega = 0: the profiles over their values at the
/// shock, in the parameter v that runs from v_0 at the centre to v_2 at the shock.
struct ClosedForm {
  double j, gamma;
  struct Values {
    double lambda, v, rho, P;
  };
  double v_centre() const { return 2 / ((j + 2) * gamma); }
  double v_shock() const { return 4 / ((j + 2) * (gamma + 1)); }
  Values at(double v) const {
    const double g = gamma, n = j + 2, d2 = 2 * (g - 1) + j, d3 = j * (2 - g);
    const double a0 = 2 / n, a2 = -(g - 1) / d2;
    const double a1 = n * g / (2 + j * (g - 1)) * (2 * j * (2 - g) / (g * n * n) - a2);
    const double a3 = j / d2, a4 = n * j * a1 / d3, a5 = -2 * j / d3;
    const double x1 = n * (g + 1) / 4 * v, x2 = (g + 1) / (g - 1) * (n * g / 2 * v - 1);
    const double x3 = n * (g + 1) / (n * (g + 1) - 2 * (2 + j * (g - 1))) * (1 - (2 + j * (g - 1)) / 2 * v);
    const double x4 = (g + 1) / (g - 1) * (1 - n / 2 * v);
    const double lambda = std::pow(x1, -a0) * std::pow(x2, -a2) * std::pow(x3, -a1);
    return {lambda, x1 * lambda, std::pow(x2, a3) * std::pow(x3, a4) * std::pow(x4, a5),
            std::pow(x1, a0 * j) * std::pow(x3, a4 - 2 * a1) * std::pow(x4, 1 + a5)};
  }
};

/// The parameter of the closed form at lambda, by bisection.
double parameter_at(const ClosedForm& closed, double lambda) {
  double low = closed.v_centre(), high = closed.v_shock();
  for (int k = 0; k < 60; ++k) (closed.at((low + high) / 2).lambda < lambda ? low : high) = (low + high) / 2;
  return high;
}

// alpha = (2/(D+2))^2 S_D times the integral of (G U^2/2 + Pi/(gamma-1)) lambda^(D-1), here over the closed form by the
// midpoint rule. Near the centre P is even and nothing moves; lambda = x2^-a2 is cut where x2 has lost half its digits.
// Kamm & Timmes print 0.851072 for 3D and gamma 1.4.
TEST(SedovSolution, AlphaIsTheEnergyOfTheClosedForm) {
  const double spheres[] = {2, 2 * M_PI, 4 * M_PI};
  EXPECT_NEAR(SedovSolution(3, 1.4).alpha(), 0.851072, 1e-6);
  for (int D = 1; D <= 3; ++D)
    for (const double gamma : {1.4, 5.0 / 3}) {
      const ClosedForm closed{double(D), gamma};
      const double G2 = (gamma + 1) / (gamma - 1), U2 = 2 / (gamma + 1), Pi2 = U2;
      const double core = std::pow(1e-9, (gamma - 1) / (2 * (gamma - 1) + D));
      const double core_P = closed.at(parameter_at(closed, core)).P;
      double integral = Pi2 * core_P / (gamma - 1) * std::pow(core, D) / D;
      constexpr int cells = 4000;
      for (int k = 0; k < cells; ++k) {
        const double width = (1 - core) / cells, lambda = core + (k + 0.5) * width;
        const auto at = closed.at(parameter_at(closed, lambda));
        const double energy = G2 * at.rho * std::pow(U2 * at.v, 2) / 2 + Pi2 * at.P / (gamma - 1);
        integral += energy * std::pow(lambda, D - 1) * width;
      }
      EXPECT_NEAR(SedovSolution(D, gamma).alpha(), std::pow(2.0 / (D + 2), 2) * spheres[D - 1] * integral, 3e-6)
          << D << "D, gamma " << gamma;
    }
}

// The table is read linearly at steps d = 2.5e-4 in ln(lambda): d^2/8 of the second derivative, which stays below 1000.
TEST(SedovSolution, EqualsTheClosedForm) {
  for (int D = 1; D <= 3; ++D)
    for (const double gamma : {1.4, 5.0 / 3}) {
      const SedovSolution solution(D, gamma);
      const ClosedForm closed{double(D), gamma};
      const double R = solution.shock_radius(1, 1, 1);
      const GasState shock = solution.behind_shock(R, 1, 1, 1);
      for (double part = 0.001; part < 1; part += 0.037) {
        const auto wanted = closed.at(closed.v_centre() + part * (closed.v_shock() - closed.v_centre()));
        const GasState state = solution.behind_shock(wanted.lambda * R, 1, 1, 1);
        EXPECT_NEAR(state.rho / shock.rho, wanted.rho, 1e-5) << D << "D, gamma " << gamma << ", " << wanted.lambda;
        EXPECT_NEAR(state.v[0] / shock.v[0], wanted.v, 1e-5) << D << "D, gamma " << gamma << ", " << wanted.lambda;
        EXPECT_NEAR(state.P / shock.P, wanted.P, 1e-5) << D << "D, gamma " << gamma << ", " << wanted.lambda;
      }
    }
}

// Integral of rho over the blast is the mass that was there: R^3/3 for rho_0 = 1, and of the energy density it is E.
TEST(SedovSolution, HoldsTheMassAndTheEnergyInsideTheShock) {
  const double E = 2.5, t = 0.3, gamma = 5.0 / 3, pi = 3.14159265358979323846;
  const SedovSolution solution(3, gamma);
  const double R = solution.shock_radius(E, 1, t);
  constexpr int cells = 20000;
  double mass = 0, energy = 0;
  for (int k = 0; k < cells; ++k) {
    const double r = (k + 0.5) * R / cells;
    const GasState s = solution.behind_shock(r, E, 1, t);
    mass += s.rho * r * r * R / cells;
    energy += (s.rho * s.v[0] * s.v[0] / 2 + s.P / (gamma - 1)) * 4 * pi * r * r * R / cells;
  }
  EXPECT_NEAR(mass, R * R * R / 3, 1e-6);
  EXPECT_NEAR(energy, E, 1e-5);
}

TEST(SedovSolution, StaysFiniteAtTheCentre) {
  const GasState state = SedovSolution(3, 5.0 / 3).behind_shock(0, 1, 1, 1);
  EXPECT_TRUE(std::isfinite(state.rho) && std::isfinite(state.v[0]) && state.P > 0);
  EXPECT_THROW(SedovSolution(3, 8), InputError);
}

}  // namespace
}  // namespace sphk
