// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/scenes/engine_keys.hpp"

namespace sphk {
namespace {

// Equal masses. The mass of the ball is the surface of its unit sphere, 2, 2 pi, 4 pi, times the integral of
// (1 - r^2)^(3/2) r^(D-1) for gamma 5/3, which is 3 pi/16, 1/5, pi/32. In 2D 1 - (3/4)^(5/2) of it lies inside r = 1/2.
TEST(Expansion, ParticlesFollowTheMassOfTheBall) {
  const double mass[] = {2 * 3 * M_PI / 16, 2 * M_PI / 5, 4 * M_PI * M_PI / 32};
  for (int D = 1; D <= 3; ++D) {
    const auto gas = expansion_scene.build(
        settings_of(expansion_scene, {{"scene.n", "40"}, {"scene.dimension", std::to_string(D)}}));
    EXPECT_NEAR(total_mass(gas), mass[D - 1], 1e-6);
    EXPECT_EQ(std::ranges::min(gas.m), std::ranges::max(gas.m));
    EXPECT_TRUE(inside_box(gas));
    EXPECT_GT(std::ranges::min(gas.u), 0);
    if (D != 2) continue;
    const auto inner = std::ranges::count_if(gas.x, [](const Array3& x) { return std::hypot(x[0], x[1]) < 0.5; });
    // A circle cuts a lattice: the number of its sites inside is good to some tens of 2500.
    EXPECT_NEAR(double(inner) / double(gas.size()), 1 - std::pow(0.75, 2.5), 0.01);
  }
}

TEST(Expansion, EndsAtFiveTimesItsRadius) {
  for (int D = 1; D <= 3; ++D) {
    const Settings settings = settings_of(expansion_scene, {{"scene.dimension", std::to_string(D)}});
    const auto exact = expansion_scene.exact(settings);
    EXPECT_GT(exact({4.9, 0, 0}, settings.real("time.end")).rho, 0) << D;
    EXPECT_EQ(exact({5.1, 0, 0}, settings.real("time.end")).rho, 0) << D;
  }
}

TEST(Expansion, TheExactSolutionHasNoErrors) {
  for (const char* variant : {"ball", "slab"}) {
    const Settings settings =
        settings_of(expansion_scene, {{"scene.n", "8"}, {"scene.across", "2"}, {"scene.variant", variant}});
    const auto gas = expansion_scene.build(settings);
    const auto exact = expansion_scene.exact(settings);
    const auto right = snapshot_of(gas, 0.4, [&](const Array3& x) { return exact(x, 0.4); });
    const auto wrong = snapshot_of(gas, 0.4, [&](const Array3& x) {
      GasState state = exact(x, 0.4);
      state.rho *= x[0] > 0 ? 1.1 : 0.9;
      return state;
    });
    EXPECT_EQ(expansion_scene.errors(settings, right).at("v_particles").linf, 0) << variant;
    EXPECT_EQ(expansion_scene.measures(settings, right)[0].second, 0) << variant;
    EXPECT_NEAR(expansion_scene.measures(settings, wrong)[0].second, 0.1, 1e-12) << variant;
  }
}

// The two sides of the slab mirror each other. Its mass is 1; the pressure in the middle, 1/gamma for as long as no
// rarefaction gets there, gives each side a momentum of t/gamma. Sums over cells of continuous functions.
TEST(Expansion, SlabConservesMassAndMomentum) {
  const Settings settings = settings_of(expansion_scene, {{"scene.variant", "slab"}, {"sph.gamma", "1.4"}});
  const auto exact = expansion_scene.exact(settings);
  double mass = 0, momentum = 0;
  constexpr int cells = 100000;
  for (int k = 0; k < cells; ++k) {
    const double x = (k + 0.5) * 3 / cells;
    const GasState right = exact({x, 0, 0}, 0.4), left = exact({-x, 0, 0}, 0.4);
    EXPECT_EQ(left.v[0], -right.v[0]);
    mass += (left.rho + right.rho) * 3 / cells;
    momentum += right.rho * right.v[0] * 3 / cells;
  }
  EXPECT_NEAR(mass, 1, 1e-8);
  EXPECT_NEAR(momentum, 0.4 / 1.4, 1e-8);
  EXPECT_GT(exact({0.5 + 1.99, 0, 0}, 0.4).rho, 0);  // the front moves at 2/(gamma-1) = 5
  EXPECT_EQ(exact({0.5 + 2.01, 0, 0}, 0.4).rho, 0);
}

TEST(Expansion, SlabIsEven) {
  for (int D = 1; D <= 3; ++D) {
    const auto gas = expansion_scene.build(settings_of(
        expansion_scene, {{"scene.variant", "slab"}, {"scene.n", "16"}, {"scene.dimension", std::to_string(D)}}));
    EXPECT_EQ(gas.size(), 16 * std::pow(8, D - 1));
    EXPECT_NEAR(total_mass(gas), std::pow(0.5, D - 1), 1e-12);
    EXPECT_EQ(gas.box.periodic, (std::array<bool, 3>{false, D > 1, D > 2}));
  }
}

}  // namespace
}  // namespace sphk
