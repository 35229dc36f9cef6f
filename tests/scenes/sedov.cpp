#include <gtest/gtest.h>

#include <cmath>

#include "src/engine/errors.hpp"
#include "tests/scenes/engine_keys.hpp"

namespace sphk {
namespace {

// E = 1 above the gas at rest: u = A rho^(gamma-1)/(gamma-1) = 0.05/(2/3) = 0.075 times the mass of the unit box.
TEST(Sedov, InjectsTheEnergyIntoTheCentre) {
  for (const char* dimension : {"1", "2", "3"}) {
    const Settings settings = settings_of(sedov_scene(), {{"scene.n", "32"}, {"scene.dimension", dimension}});
    const ParticleSet gas = sedov_scene().build(settings);
    double energy = 0;
    for (std::size_t i = 0; i < gas.size(); ++i) {
      energy += gas.m[i] * gas.u[i];
      const double r = std::hypot(gas.x[i][0], gas.x[i][1], gas.x[i][2]);
      EXPECT_EQ(gas.u[i] > 0.0751, r < 0.08) << r;
    }
    EXPECT_NEAR(total_mass(gas), 1, 1e-12);
    EXPECT_NEAR(energy, 1.075, 8e-12) << dimension;  // the rounding of 32768 additions
  }
}

TEST(Sedov, RefusesABlastWithoutParticles) {
  EXPECT_THROW(sedov_scene().build(settings_of(sedov_scene(), {{"scene.n", "8"}, {"scene.blast_radius", "0.01"}})),
               InputError);
}

// r = 1.15 (E t^2 / rho)^(1/5) = 0.347 at t = 0.05 (S12 eq 47): just inside rho is near 4, v outwards; outside at rest.
TEST(Sedov, ExactSolutionPointsOutwards) {
  const Settings settings = settings_of(sedov_scene());
  const auto exact = sedov_scene().exact(settings);
  const GasState outside = exact({0, 0.36, 0}, 0.05), inside = exact({0, -0.34, 0}, 0.05);
  EXPECT_EQ(outside.rho, 1);
  EXPECT_EQ(outside.P, 0.05);
  EXPECT_GT(inside.rho, 2.5);
  EXPECT_LT(inside.v[1], 0);
  EXPECT_EQ(inside.v[0], 0);
  EXPECT_TRUE(std::isfinite(exact({0, 0, 0}, 0.05).rho));
}

TEST(Sedov, ErrorsOfTheExactSolution) {
  const Settings settings = settings_of(sedov_scene(), {{"scene.n", "32"}});
  const auto snapshot = exact_snapshot(sedov_scene(), settings, 0.05);
  EXPECT_EQ(sedov_scene().errors(settings, snapshot).at("rho_particles").linf, 0);
  const auto measures = sedov_scene().measures(settings, snapshot);
  ASSERT_EQ(measures.size(), 3u);
  EXPECT_GT(measures[0].second, 2);
  EXPECT_LE(measures[0].second, 4);
  // The lattice samples a shell of about one spacing: the sum over some thousand directions is good to a percent or so.
  EXPECT_NEAR(measures[1].second, measures[2].second, 0.02 * measures[2].second);
  EXPECT_NEAR(measures[2].second, 1.15 * std::pow(0.05 * 0.05, 0.2), 2e-3) << "S12 eq 47";
}

}  // namespace
}  // namespace sphk
