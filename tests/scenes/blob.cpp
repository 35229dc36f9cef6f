// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "tests/scenes/engine_keys.hpp"

namespace sphk {
namespace {

using Keys = std::vector<std::pair<std::string, std::string>>;

ParticleSet gas_of(const Keys& keys) {
  return blob_scene.build(settings_of(blob_scene, keys));
}

/// Place relative to the cloud's centre.
Array3 offset(const Array3& x) {
  return {x[0] - 5, x[1] - 5, x[2] - 5};
}
double distance(const Array3& x) {
  return std::hypot(x[0] - 5, x[1] - 5, x[2] - 5);
}

double cloud_mass_of(const ParticleSet& gas) {
  double mass = 0;
  for (std::size_t i = 0; i < gas.size(); ++i)
    if (gas.tag[i] == 1) mass += gas.m[i];
  return mass;
}

// 4 pi/3 at density 10, and the wind fills the rest of 3000 at density 1; a lattice fills a ball of radius R in
// spacings to about R^(3/2)/R^3 of its volume (R = 3.2 and 6.9 here).
TEST(Blob, CloudIsTenTimesDenser) {
  const ParticleSet equal = gas_of({{"scene.n", "32"}}), multi = gas_of({{"scene.n", "32"}, {"scene.masses", "multi"}});
  const double cloud = 40 * std::numbers::pi / 3;
  EXPECT_NEAR(cloud_mass_of(equal) / cloud, 1, std::pow(6.9, -1.5));
  EXPECT_NEAR(cloud_mass_of(multi) / cloud, 1, std::pow(3.2, -1.5));
  EXPECT_NEAR(total_mass(equal), 3000 + 0.9 * cloud, 0.2 * cloud);
  EXPECT_EQ(multi.size(), 3u * 32 * 32 * 32);
  for (const double m : equal.m) ASSERT_EQ(m, equal.m[0]);
  for (std::size_t i = 0; i < multi.size(); ++i) ASSERT_EQ(multi.m[i] / multi.m[0], multi.tag[i] == 1 ? 10 : 1);
  EXPECT_TRUE(inside_box(equal));
}

// rho = c = 1 in the wind: P = 1/gamma, u = 1/(gamma (gamma - 1)) = 0.9, a tenth of it in the cloud; v = 2.7.
TEST(Blob, WindAndCloudAreInPressureBalance) {
  const ParticleSet gas = gas_of({{"scene.n", "16"}});
  for (std::size_t i = 0; i < gas.size(); ++i) {
    const bool dense = distance(gas.x[i]) < 1;
    ASSERT_EQ(gas.tag[i], dense ? 1 : 0);
    ASSERT_NEAR(gas.u[i], dense ? 0.09 : 0.9, 1e-14);
    if (!dense) {
      ASSERT_EQ(gas.v[i], (Array3{2.7, 0, 0}));
    }
  }
}

// tau_KH = 1.6 * 2 sqrt(10) / 2.7 = 3.7479.
TEST(Blob, RunsForTwoGrowthTimes) {
  EXPECT_NEAR(settings_of(blob_scene).real("time.end"), 2 * 3.7479, 1e-4);
}

// tau_KH = 3.7479; the bands of converged grid runs, over the start where the measure is not 1 there. The share of cold
// gas turns at T = T_wind / 2, u = 0.45: of a cloud whose every second particle is a little hotter half is left.
TEST(Blob, KnowsWhatGridsFind) {
  const Settings settings = settings_of(blob_scene, {{"scene.n", "16"}});
  const auto references = blob_scene.references(settings);
  ASSERT_EQ(references.size(), 4u);
  for (const Reference& r : references) EXPECT_EQ(r.over_start, r.measure == "cloud_mass");
  EXPECT_NEAR(references[1].time, 3.7479, 1e-4);
  EXPECT_EQ(references[1].low, 0.461);
  EXPECT_EQ(references[1].high, 0.546);
  EXPECT_EQ(references[3].measure, "cold_share");
  ParticleSet gas = blob_scene.build(settings);
  std::size_t dense = 0;
  for (std::size_t i = 0; i < gas.size(); ++i)
    if (gas.tag[i] == 1) gas.u[i] = dense++ % 2 == 0 ? 0.449 : 0.451;
  const auto start = start_snapshot(gas, 5.0 / 3, [](const Array3&) { return 1.0; });
  EXPECT_NEAR(blob_scene.measures(settings, start)[1].second, 0.5, 0.5 / double(dense));
}

// The skin's motion is radial, at most 0.06 * 2.7 = 0.162 exp(2 (r - 1)), and comes near to that somewhere.
TEST(Blob, SkinIsDisturbedRadially) {
  const ParticleSet gas = gas_of({{"scene.n", "48"}});
  double largest = 0;
  for (std::size_t i = 0; i < gas.size(); ++i) {
    if (gas.tag[i] != 1) continue;
    const Array3 d = offset(gas.x[i]), v = gas.v[i];
    const double r = distance(gas.x[i]), v_r = (d[0] * v[0] + d[1] * v[1] + d[2] * v[2]) / r;
    ASSERT_NEAR(std::hypot(v[0], v[1], v[2]), std::abs(v_r), 1e-15);
    ASSERT_LE(std::abs(v_r), 0.162 * std::exp(2 * (r - 1)) * (1 + 1e-12));
    largest = std::max(largest, std::abs(v_r));
  }
  EXPECT_GT(largest, 0.12);
}

// All mass of dense origin is cloud; quarter turns about the wind's axis map the lattice onto itself and cancel cos(3
// phi).
TEST(Blob, StartsWholeAndAtRest) {
  const Settings settings = settings_of(blob_scene, {{"scene.n", "16"}});
  const auto rho = [](const Array3& x) { return distance(x) < 1 ? 10.0 : 1.0; };
  const auto start = start_snapshot(blob_scene.build(settings), 5.0 / 3, rho);
  const auto measures = blob_scene.measures(settings, start);
  ASSERT_EQ(measures.size(), 3u);
  EXPECT_EQ(measures[0].first, "cloud_mass");
  EXPECT_NEAR(measures[0].second, 1, 1e-12);
  EXPECT_EQ(measures[1].first, "cold_share");
  EXPECT_EQ(measures[1].second, 1);
  EXPECT_EQ(measures[2].first, "cloud_velocity");
  EXPECT_NEAR(measures[2].second, 0, 1e-15);
}

}  // namespace
}  // namespace sphk
