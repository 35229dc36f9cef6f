// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/scenes/engine_keys.hpp"

namespace sphk {
namespace {

Settings tube(const std::string& problem, std::vector<std::pair<std::string, std::string>> keys = {}) {
  keys.emplace_back("scene.problem", problem);
  return settings_of(tube_scene, keys);
}

// Between the waves, a little left and right of the contact. Toro (2009) table 4.3 for the first three; the strong
// blast has rho 6 behind its shock (gamma 1.4), whose speed is 6/5 of the gas's.
TEST(Tube, HasTheStatesOfItsProblems) {
  const auto state = [](const char* problem, double x, double t) {
    return tube_scene.exact(tube(problem))({x, 0, 0}, t);
  };
  EXPECT_NEAR(state("blast", 0.5 + 19.59 * 0.0075, 0.0075).P, 460.894, 1e-3);
  EXPECT_NEAR(state("blast", 0.5 + 19.61 * 0.0075, 0.0075).rho, 5.99924, 1e-5);
  EXPECT_NEAR(state("rarefactions", 0.5, 0.15).P, 0.00189, 5e-6);
  EXPECT_NEAR(state("rarefactions", 0.5, 0.15).rho, 0.02185, 5e-6);
  EXPECT_NEAR(state("strong-blast", 40.7 * 0.015, 0.015).rho, 6, 1e-4);
  EXPECT_NEAR(state("strong-blast", 40.7 * 0.015, 0.015).v[0], 40.733 / 1.2, 1e-3);
  EXPECT_NEAR(state("leblanc", 3 + 0.625 * 6, 6).rho, 0.004, 1e-6);  // 4 behind the shock of a gas of 5/3
  EXPECT_NEAR(state("leblanc", 3 + 0.61 * 6, 6).rho, 0.05408, 1e-5);
  // The slow shock: (rho v)_left = (rho v)_right in its frame, which moves at 0.1096.
  const GasState left = state("slow-shock", -1, 0), right = state("slow-shock", 1, 0);
  const double speed = (left.rho * left.v[0] - right.rho * right.v[0]) / (left.rho - right.rho);
  EXPECT_NEAR(speed, 0.1096, 1e-4);
  EXPECT_NEAR(left.P + left.rho * std::pow(left.v[0] - speed, 2), right.P + right.rho * std::pow(right.v[0] - speed, 2),
              1e-4);
}

// Two cold streams of speed 1 that meet: a strong shock leaves rho 4 at rest (gamma 5/3), P = 4/3 rho v^2.
TEST(Tube, StreamsMeetInAStrongShock) {
  const auto settings = tube("streams", {{"scene.mach", "1e5"}});
  const GasState middle = tube_scene.exact(settings)({0.01, 0, 0}, 1);
  EXPECT_NEAR(middle.rho, 4, 1e-8);
  EXPECT_NEAR(middle.v[0], 0, 1e-12);
  EXPECT_NEAR(middle.P, 4.0 / 3, 1e-8);
  EXPECT_NEAR(tube_scene.exact(settings)({0.5, 0, 0}, 0).P, 0.6e-10, 1e-22);  // v^2 / (gamma M^2)
}

TEST(Tube, WallsAreMirrors) {
  const auto gas = tube_scene.build(tube("leblanc", {{"scene.n", "20"}}));
  ASSERT_EQ(gas.size(), 2u * 9 * 20);
  EXPECT_TRUE(gas.box.periodic[0]);
  EXPECT_EQ(gas.box.lower[0], -9);
  EXPECT_EQ(gas.box.size[0], 18);
  for (std::size_t i = 0; i < gas.size(); i += 2) {
    EXPECT_EQ(gas.x[i + 1][0], -gas.x[i][0]);
    EXPECT_EQ(gas.v[i + 1][0], -gas.v[i][0]);
    EXPECT_EQ(gas.m[i + 1], gas.m[i]);
    EXPECT_NEAR(gas.m[i], (gas.x[i][0] < 3 ? 1 : 1e-3) / 20, 1e-15);
  }
  const auto open = tube_scene.build(tube("rarefactions", {{"scene.n", "20"}}));
  EXPECT_EQ(open.size(), 60u);
  EXPECT_FALSE(open.box.periodic[0]);
}

TEST(Tube, HasTheSameDensityInThreeDimensions) {
  const auto gas =
      tube_scene.build(tube("blast", {{"scene.n", "16"}, {"scene.dimension", "3"}, {"scene.across", "4"}}));
  EXPECT_EQ(gas.size(), 2u * 16 * 4 * 4);
  EXPECT_NEAR(gas.m[0], std::pow(1.0 / 16, 3), 1e-15);
  EXPECT_NEAR(gas.box.size[1], 0.25, 1e-15);
}

}  // namespace
}  // namespace sphk
