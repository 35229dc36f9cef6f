// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "src/engine/errors.hpp"
#include "tests/scenes/engine_keys.hpp"

namespace sphk {
namespace {

// E = 1 above the gas at rest: u = A rho^(gamma-1)/(gamma-1) = 0.05/(2/3) = 0.075 times the mass of the unit box.
TEST(Sedov, InjectsTheEnergyIntoTheCentre) {
  for (const char* dimension : {"1", "2", "3"}) {
    const Settings settings = settings_of(sedov_scene, {{"scene.n", "32"}, {"scene.dimension", dimension}});
    const ParticleSet gas = sedov_scene.build(settings);
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
  EXPECT_THROW(sedov_scene.build(settings_of(sedov_scene, {{"scene.n", "8"}, {"scene.blast_radius", "0.01"}})),
               InputError);
}

// r = 1.15 (E t^2 / rho)^(1/5) = 0.347 at t = 0.05 (S12 eq 47): just inside rho is near 4, v outwards; outside at rest.
TEST(Sedov, ExactSolutionPointsOutwards) {
  const Settings settings = settings_of(sedov_scene);
  const auto exact = sedov_scene.exact(settings);
  const GasState outside = exact({0, 0.36, 0}, 0.05), inside = exact({0, -0.34, 0}, 0.05);
  EXPECT_EQ(outside.rho, 1);
  EXPECT_EQ(outside.P, 0.05);
  EXPECT_GT(inside.rho, 2.5);
  EXPECT_LT(inside.v[1], 0);
  EXPECT_EQ(inside.v[0], 0);
  EXPECT_TRUE(std::isfinite(exact({0, 0, 0}, 0.05).rho));
}

TEST(Sedov, TheExactSolutionHasNoErrors) {
  const Settings settings = settings_of(sedov_scene, {{"scene.n", "32"}});
  const auto snapshot = exact_snapshot(sedov_scene, settings, 0.05);
  EXPECT_EQ(sedov_scene.errors(settings, snapshot).at("rho_particles").linf, 0);
  const auto measures = sedov_scene.measures(settings, snapshot);
  ASSERT_EQ(measures.size(), 4u);
  EXPECT_GT(measures[0].second, 2);
  EXPECT_LE(measures[0].second, 4);
  // The lattice samples a shell of about one spacing: the sum over some thousand directions is good to a percent or so.
  EXPECT_NEAR(measures[1].second, measures[2].second, 0.02 * measures[2].second);
  EXPECT_NEAR(measures[2].second, 1.15 * std::pow(0.05 * 0.05, 0.2), 2e-3) << "S12 eq 47";
  EXPECT_NEAR(measures[3].second, 0, 1e-12) << "the lattice is the same along all axes";
}

// Gas that moves as v = 2 r is the same along all axes. With the particles of one side 1.1 times as far out, and so
// as fast, its mean radius is 1.1 times that of the other three: 0.1 / ((3 + 1.1) / 4).
TEST(Sedov, MeasuresItsRoundness) {
  const Settings settings = settings_of(sedov_scene, {{"scene.n", "64"}, {"scene.dimension", "2"}});
  ParticleSet gas = sedov_scene.build(settings);
  const auto moving = [](const Array3& x) { return GasState{1, {2 * x[0], 2 * x[1], 0}, 1}; };
  EXPECT_NEAR(sedov_scene.measures(settings, snapshot_of(gas, 0, moving))[3].second, 0, 1e-12);
  for (Array3& x : gas.x)
    if (x[0] > std::abs(x[1]))
      for (double& s : x) s *= 1.1;
  EXPECT_NEAR(sedov_scene.measures(settings, snapshot_of(gas, 0, moving))[3].second, 0.4 / 4.1, 1e-12);
}

// Masses jump by k^D at x = a, the first place from 0.125 on where both lattices end on whole cells; the density is 1
// on both sides.
TEST(Sedov, IsCoarserAtOneSide) {
  for (const int D : {1, 2, 3})
    for (const int k : {2, 4}) {
      const ParticleSet gas = sedov_scene.build(settings_of(
          sedov_scene,
          {{"scene.n", "16"}, {"scene.coarser", std::to_string(k)}, {"scene.dimension", std::to_string(D)}}));
      EXPECT_NEAR(total_mass(gas), 1, 1e-12);
      EXPECT_TRUE(inside_box(gas));
      double light_mass = 0, light_end = -1, heavy_start = 1;
      for (std::size_t i = 0; i < gas.size(); ++i) {
        const bool light = gas.m[i] < 1.5 * std::pow(16, -D);
        EXPECT_NEAR(gas.m[i] * std::pow(light ? 16 : 16.0 / k, D), 1, 1e-12);
        if (light) light_mass += gas.m[i], light_end = std::max(light_end, gas.x[i][0]);
        if (!light) heavy_start = std::min(heavy_start, gas.x[i][0]);
      }
      const double a = k == 2 ? 0.125 : 0.25;  // 6/16 are 3 cells of 2/16; one cell of 4/16 ends by 0.5
      EXPECT_NEAR(light_mass, 0.5 + a, 1e-12);
      EXPECT_NEAR(light_end, a - 0.5 / 16, 1e-12);
      EXPECT_NEAR(heavy_start, a + 0.5 * k / 16, 1e-12);
    }
  EXPECT_THROW(sedov_scene.build(settings_of(sedov_scene, {{"scene.n", "18"}, {"scene.coarser", "4"}})), InputError);
}

}  // namespace
}  // namespace sphk
