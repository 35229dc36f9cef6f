#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenes/engine_keys.hpp"

namespace sphk {
namespace {

TEST(UniformGas, FillsBoxesOfAnyDimension) {
  for (int D = 1; D <= 3; ++D) {
    const auto gas = uniform_scene().build(settings_of(uniform_scene(), {{"scene.n", "8"}, {"scene.lattice", "cubic"},
                                                                         {"scene.dimension", std::to_string(D)}}));
    EXPECT_EQ(gas.dimension, D);
    EXPECT_EQ(gas.size(), std::size_t(std::pow(8, D)));
    EXPECT_NEAR(total_mass(gas), 1, 1e-13);
  }
}

TEST(UniformGas, MakesThinSlabs) {
  const auto gas = uniform_scene().build(settings_of(
      uniform_scene(), {{"scene.n", "16"}, {"scene.layers", "4"}, {"scene.lattice", "cubic"}}));
  EXPECT_EQ(gas.size(), 16u * 16 * 4);
  EXPECT_EQ(gas.box.size, (Array3{1, 1, 0.25}));
  EXPECT_NEAR(total_mass(gas), 0.25, 1e-13);
}

// Shifts are at most 0.3 of the spacing 1/16, on every axis, and differ between seeds.
TEST(UniformGas, JitterIsBoundedAndRepeatable) {
  const auto build = [](const char* jitter, const char* seed) {
    return uniform_scene().build(settings_of(uniform_scene(), {{"scene.n", "16"}, {"scene.jitter", jitter},
                                                               {"scene.seed", seed}, {"scene.lattice", "cubic"}}));
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
  const Settings settings = settings_of(uniform_scene(), {{"scene.n", "8"}, {"scene.lattice", "cubic"}});
  const auto snapshot = snapshot_of(uniform_scene().build(settings), 0, [](const Array3&) {
    return GasState{1.07, {}, 1};
  });
  EXPECT_NEAR(uniform_scene().errors(settings, snapshot).at("rho").l1, 0.07, 1e-14);
}

}  // namespace
}  // namespace sphk
