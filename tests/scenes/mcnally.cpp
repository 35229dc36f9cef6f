// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <numbers>

#include "tests/scenes/engine_keys.hpp"

namespace sphk {
namespace {

using Keys = std::vector<std::pair<std::string, std::string>>;

ParticleSet gas_of(const Keys& keys) {
  return mcnally_scene.build(settings_of(mcnally_scene, keys));
}

/// Mass below y <= 1/4: the integral of 1 + 0.5 exp((y - 1/4)/0.025).
double mass_below(double y) {
  return y + 0.0125 * (std::exp((y - 0.25) / 0.025) - std::exp(-10.0));
}

// Rows at (r + 1/2)/n of the mass, 1.5 in all. The table of 16384 cells is good to (cell/0.025)^2/24 = 2e-7.
TEST(McNally, RowsFollowTheDensity) {
  const ParticleSet gas = gas_of({{"scene.n", "64"}});
  ASSERT_EQ(gas.size(), 64u * 64);
  EXPECT_NEAR(total_mass(gas), 1.5, 1e-6);
  int compared = 0;
  for (int r = 0; r < 64; ++r) {
    const double y = gas.x[r][1];  // the lattice runs through y first in 2D
    if (y > 0.25) continue;
    EXPECT_NEAR(mass_below(y), (r + 0.5) / 64 * 1.5, 1e-6) << r;
    ++compared;
  }
  EXPECT_EQ(compared, 11);  // 0.2625 of 1.5 lies below 1/4: 11.2 of 64 rows
}

// At the interfaces the mean of both gases; beyond, within exp(-10) of a half step of either.
TEST(McNally, RampsJoinTheGases) {
  const ParticleSet gas = gas_of({{"scene.n", "128"}, {"scene.masses", "multi"}});
  const double area = 1.0 / (128 * 128);
  EXPECT_NEAR(total_mass(gas), 1.5, 1e-12);  // a ramp has as much too much as the other has too little
  for (std::size_t i = 0; i < gas.size(); ++i) {
    const double rho = gas.m[i] / area, y = gas.x[i][1];
    const double share = y < 0.5
                             ? (y < 0.25 ? 0.5 * std::exp((y - 0.25) / 0.025) : 1 - 0.5 * std::exp((0.25 - y) / 0.025))
                             : (y < 0.75 ? 1 - 0.5 * std::exp((y - 0.75) / 0.025) : 0.5 * std::exp((0.75 - y) / 0.025));
    ASSERT_NEAR(rho, 1 + share, 1e-12) << y;
    ASSERT_NEAR(gas.v[i][0], 0.5 - share, 1e-12) << y;
    ASSERT_NEAR(gas.u[i] * rho * (2.0 / 3), 2.5, 1e-12) << y;
    ASSERT_NEAR(gas.v[i][1], 0.01 * std::sin(4 * std::numbers::pi * gas.x[i][0]), 1e-15);
  }
}

// v_y = 0.01 sin(kx) everywhere: M = 0.01, whatever the weights.
TEST(McNally, StartsWithTheSeededMode) {
  for (const Keys& keys : {Keys{{"scene.n", "64"}, {"scene.dimension", "3"}, {"scene.layers", "4"}},
                           Keys{{"scene.n", "64"}, {"scene.masses", "multi"}}}) {
    const Settings settings = settings_of(mcnally_scene, keys);
    const auto start = start_snapshot(mcnally_scene.build(settings), 5.0 / 3, [](const Array3&) { return 1.0; });
    const auto measures = mcnally_scene.measures(settings, start);
    EXPECT_NEAR(measures[0].second, 0.01, 1e-15);
    EXPECT_EQ(measures[3].second, 0);
  }
}

}  // namespace
}  // namespace sphk
