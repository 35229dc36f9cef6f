// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenes/engine_keys.hpp"

namespace sphk {
namespace {

TEST(UniformGas, FillsBoxesOfAnyDimension) {
  for (int D = 1; D <= 3; ++D) {
    const auto gas = uniform_scene.build(settings_of(
        uniform_scene, {{"scene.n", "8"}, {"scene.lattice", "cubic"}, {"scene.dimension", std::to_string(D)}}));
    EXPECT_EQ(gas.dimension, D);
    EXPECT_EQ(gas.size(), std::size_t(std::pow(8, D)));
    EXPECT_NEAR(total_mass(gas), 1, 1e-13);
  }
}

TEST(UniformGas, MakesThinSlabs) {
  const auto gas = uniform_scene.build(
      settings_of(uniform_scene, {{"scene.n", "16"}, {"scene.layers", "4"}, {"scene.lattice", "cubic"}}));
  EXPECT_EQ(gas.size(), 16u * 16 * 4);
  EXPECT_EQ(gas.box.size, (Array3{1, 1, 0.25}));
  EXPECT_NEAR(total_mass(gas), 0.25, 1e-13);
}

// Shifts are at most 0.3 of the spacing 1/16, on every axis, and differ between seeds.
TEST(UniformGas, JitterIsBoundedAndRepeatable) {
  const auto build = [](const char* jitter, const char* seed) {
    return uniform_scene.build(
        settings_of(uniform_scene,
                    {{"scene.n", "16"}, {"scene.jitter", jitter}, {"scene.seed", seed}, {"scene.lattice", "cubic"}}));
  };
  const auto still = build("0", "1"), shaken = build("0.3", "1");
  double largest = 0;
  for (std::size_t i = 0; i < still.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, std::abs(shaken.x[i][axis] - still.x[i][axis]));
  EXPECT_LE(largest, 0.3 / 16 + 1e-15);
  EXPECT_GT(largest, 0.29 / 16);  // of 12288 shifts one reaches this but for a chance of (29/30)^12288
  EXPECT_EQ(shaken.x, build("0.3", "1").x);
  EXPECT_NE(shaken.x, build("0.3", "2").x);
  EXPECT_TRUE(inside_box(build("3", "1")));
}

TEST(UniformGas, DensityErrorsAreAgainstOne) {
  const Settings settings = settings_of(uniform_scene, {{"scene.n", "8"}, {"scene.lattice", "cubic"}});
  const auto snapshot = snapshot_of(uniform_scene.build(settings), 0, [](const Array3&) {
    return GasState{1.07, {}, 1};
  });
  EXPECT_NEAR(uniform_scene.errors(settings, snapshot).at("rho").l1, 0.07, 1e-14);
}

// On a lattice the nearest neighbour is one spacing away, in thin slabs as well. Of points that lie at random, each for
// itself, a share of exp(-n V r^D) has none within r (V: 2, pi, 4 pi/3): 0.95 where n V r^D = 0.0513. Of 32768
// particles, many of which are each other's nearest, the rank of that is good to 3.4 %, and r to a share of 1/D of it.
TEST(UniformGas, MeasuresTheNearestNeighbour) {
  const double sphere[] = {2, M_PI, 4 * M_PI / 3};
  const char* n[] = {"32768", "181", "32"};
  for (int D = 1; D <= 3; ++D)
    for (const char* lattice : {"cubic", "random"}) {
      const Settings settings = settings_of(
          uniform_scene, {{"scene.n", n[D - 1]}, {"scene.dimension", std::to_string(D)}, {"scene.lattice", lattice}});
      const auto gas = uniform_scene.build(settings);
      EXPECT_TRUE(inside_box(gas));
      const auto even = [](const Array3& x) { return GasState{x[0] < 0.5 ? 0.9 : 1.1, {}, 1}; };
      const auto measures = uniform_scene.measures(settings, snapshot_of(gas, 0, even));
      const bool cubic = std::string(lattice) == "cubic";
      EXPECT_NEAR(measures[0].second, 0.1, cubic ? 0.001 : 0.002);
      const double expected = cubic ? 1 : std::pow(-std::log(0.95) / sphere[D - 1], 1.0 / D);
      EXPECT_NEAR(measures[1].second / expected, 1, cubic ? 1e-9 : 0.1 / D) << D;
    }
  const Settings slab =
      settings_of(uniform_scene, {{"scene.n", "16"}, {"scene.layers", "4"}, {"scene.lattice", "cubic"}});
  const auto flat = snapshot_of(uniform_scene.build(slab), 0, [](const Array3&) { return GasState{1, {}, 1}; });
  EXPECT_NEAR(uniform_scene.measures(slab, flat)[1].second, 1, 1e-9);
}

TEST(UniformGas, RandomPlacesDependOnTheSeed) {
  const auto build = [](const char* seed) {
    return uniform_scene.build(
        settings_of(uniform_scene, {{"scene.n", "8"}, {"scene.lattice", "random"}, {"scene.seed", seed}}));
  };
  EXPECT_EQ(build("1").x, build("1").x);
  EXPECT_NE(build("1").x, build("2").x);
}

}  // namespace
}  // namespace sphk
