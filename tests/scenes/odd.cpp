// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/scenes/engine_keys.hpp"

namespace sphk {
namespace {

ParticleSet odd(const std::string& problem) {
  const ParticleSet gas = odd_scene.build(settings_of(odd_scene, {{"scene.problem", problem}}));
  EXPECT_NEAR(total_mass(gas), 1, 1e-12) << problem;
  return gas;
}

std::size_t places(const ParticleSet& gas, std::size_t axis) {
  std::set<double> found;
  for (const Array3& x : gas.x) found.insert(x[axis]);
  return found.size();
}

TEST(Odd, ProblemsAreWhatTheirNamesSay) {
  for (const auto& [problem, at_one_place] : {std::pair("pair", 2), {"ten", 10}}) {
    const ParticleSet gas = odd(problem);
    EXPECT_EQ(gas.size(), 512u);
    EXPECT_EQ(std::ranges::count(gas.x, gas.x[0]), at_one_place);
    EXPECT_TRUE(gas.box.periodic[2]);
  }
  EXPECT_EQ(places(odd("plane"), 2), 1u);
  EXPECT_EQ(places(odd("plane"), 0), 512u);
  EXPECT_EQ(odd("one").size(), 1u);
  const ParticleSet two = odd("two"), line = odd("line"), ejected = odd("ejected");
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two.x[1][0] - two.x[0][0], 1e6);
  EXPECT_EQ(line.size(), 64u);
  EXPECT_EQ(places(line, 1) * places(line, 2), 1u);
  // The speed of sound is sqrt(gamma (gamma - 1) u).
  const double c = std::sqrt(5.0 / 3 * 2 / 3 * ejected.u.back());
  EXPECT_NEAR(ejected.v.back()[0], 1e3 * c, 1e-9 * c);
  EXPECT_EQ(std::ranges::count(ejected.v, Array3{}), 511);
  EXPECT_FALSE(ejected.box.periodic[0]);
}

}  // namespace
}  // namespace sphk
