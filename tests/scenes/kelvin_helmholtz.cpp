// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "src/engine/errors.hpp"
#include "tests/scenes/engine_keys.hpp"

namespace sphk {
namespace {

using Keys = std::vector<std::pair<std::string, std::string>>;

ParticleSet gas_of(const Scene& scene, const Keys& keys) {
  return scene.build(settings_of(scene, keys));
}

double mass_within(const ParticleSet& gas, double y) {
  double mass = 0;
  for (std::size_t i = 0; i < gas.size(); ++i)
    if (std::abs(gas.x[i][1]) < y) mass += gas.m[i];
  return mass;
}

// S12 sec 7.5 has 2,359,296 particles of equal mass and 524,288 of two masses at n = 256 in a slab of 1/32; a quarter
// of the resolution makes 1/64 of them. R10's lattices of 256 and 320 along x: 2 x 64 x 16 x 8 of the light gas and 80
// x 41 x 10 of the dense gas, 41 = round(2 * 16384 / 800).
TEST(KelvinHelmholtz, CountsArePapers) {
  const Keys slab{{"scene.n", "64"}, {"scene.layers", "2"}};
  EXPECT_EQ(gas_of(kh18_scene, slab).size(), 2359296u / 64);
  EXPECT_EQ(gas_of(kh18_scene, {{"scene.n", "64"}, {"scene.layers", "2"}, {"scene.masses", "multi"}}).size(),
            524288u / 64);
  EXPECT_EQ(gas_of(kh18_scene, slab).box.size, (Array3{1, 1, 1.0 / 32}));
  EXPECT_EQ(gas_of(kh12_scene, {{"scene.n", "64"}}).size(), 16384u + 32800);
  EXPECT_THROW(gas_of(kh12_scene, {{"scene.n", "30"}}), InputError);
}

// Mean density (1 + ratio)/2 whatever the sampling; masses are equal, or differ by the ratio.
TEST(KelvinHelmholtz, MassesAreEqualOrDifferByTheRatio) {
  for (const char* dimension : {"2", "3"})
    for (const char* edges : {"sharp", "soft"}) {
      const Keys keys{{"scene.n", "32"}, {"scene.dimension", dimension}, {"scene.edges", edges}};
      const ParticleSet equal = gas_of(kh18_scene, keys);
      EXPECT_NEAR(total_mass(equal), 4.5 * equal.box.size[2], 1e-9) << edges << dimension;
      EXPECT_TRUE(inside_box(equal));
      for (const double m : equal.m) ASSERT_EQ(m, equal.m[0]);
    }
  const ParticleSet multi = gas_of(kh18_scene, {{"scene.n", "32"}, {"scene.masses", "multi"}});
  for (std::size_t i = 0; i < multi.size(); ++i)
    ASSERT_NEAR(multi.m[i], std::pow(32, -3) * (multi.tag[i] == 1 ? 8 : 1), 1e-17);
}

// Soft edges: mass within |y| < s is 2 s + 7 times the integral of the dense share (1 + tanh((1/4 - |y|)/0.01))/2,
// which is s + 0.01 [ln cosh 25 - ln cosh((1/4 - s)/0.01)]. The particles meet it to one row of 1/64 of the half layer.
TEST(KelvinHelmholtz, EqualMassesFollowTheSoftEdges) {
  const ParticleSet gas = gas_of(kh18_scene, {{"scene.n", "64"}, {"scene.edges", "soft"}, {"scene.dimension", "2"}});
  for (const double s : {0.2, 0.24, 0.25, 0.26, 0.3}) {
    const double share = s + 0.01 * (std::log(std::cosh(25.0)) - std::log(std::cosh((0.25 - s) / 0.01)));
    EXPECT_NEAR(mass_within(gas, s), 2 * s + 7 * share, 8.0 / 128) << s;
  }
}

// rho_2 = 1 and P = 0.6 give c_2 = 1 and u_2 = 0.9; speeds of 0.11; u_1 = u_2 / ratio.
TEST(KelvinHelmholtz, StatesAreInPressureBalance) {
  for (const auto& [scene, ratio] : {std::pair{&kh12_scene, 2.0}, std::pair{&kh18_scene, 8.0}}) {
    const ParticleSet gas = gas_of(*scene, {{"scene.n", "16"}});
    for (std::size_t i = 0; i < gas.size(); ++i) {
      const bool dense = std::abs(gas.x[i][1]) < 0.25;
      ASSERT_EQ(gas.tag[i], dense ? 1 : 0);
      ASSERT_NEAR(gas.v[i][0], dense ? 0.11 : -0.11, 1e-15);
      ASSERT_NEAR(gas.u[i], dense ? 0.9 / ratio : 0.9, 1e-14);
    }
  }
}

// tau_KH = (rho_1 + rho_2) lambda / (sqrt(rho_1 rho_2) v): 3 * 0.5 / (sqrt 2 * 0.22) = 4.82118; two of them are run.
TEST(KelvinHelmholtz, RunsForTwoGrowthTimes) {
  EXPECT_NEAR(settings_of(kh12_scene).real("time.end"), 2 * 4.82118, 1e-5);
  EXPECT_NEAR(settings_of(kh18_scene).real("time.end"), 2 * 4.5 / (std::sqrt(8) * 0.22), 1e-12);
}

TEST(KelvinHelmholtz, BoostAddsToTheVelocityAlongXAlone) {
  const ParticleSet still = gas_of(kh12_scene, {{"scene.n", "16"}});
  const ParticleSet moving = gas_of(kh12_scene, {{"scene.n", "16"}, {"scene.boost", "3"}});
  EXPECT_EQ(still.x, moving.x);
  for (std::size_t i = 0; i < still.size(); ++i) {
    ASSERT_NEAR(moving.v[i][0] - still.v[i][0], 3, 1e-14);
    ASSERT_EQ(moving.v[i][1], still.v[i][1]);
  }
}

// v_y = 0.0275 exp(-100 d^2) near an interface, weighted by exp(-k d) up to d = 1/4, k = 4 pi: M = 0.0275 I / N with
// N = 2 (1 - exp(-k/4)) / k = 0.152277 and I = (sqrt(pi)/10) exp(k^2/400) erfc(k/20) = 0.098439; the cut at 1/4 and the
// other interface change I by less than 1e-4 of it. Rows of 1/64 weaken w by about cosh(k/128) - 1 = 0.5 %.
TEST(KelvinHelmholtz, StartsUnmixedWithTheSeededMode) {
  const Settings settings = settings_of(
      kh12_scene, {{"scene.n", "64"}, {"scene.dimension", "2"}, {"scene.masses", "multi"}, {"scene.boost", "1"}});
  const auto rho = [](const Array3& x) { return std::abs(x[1]) < 0.25 ? 2.0 : 1.0; };
  const auto start = start_snapshot(kh12_scene.build(settings), 5.0 / 3, rho);
  const auto measures = kh12_scene.measures(settings, start);
  ASSERT_EQ(measures.size(), 4u);
  const char* names[] = {"M", "W", "mixA", "crossed"};
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(measures[i].first, names[i]);
    EXPECT_NEAR(measures[i].second, i == 0 ? 0.017777 : 0, i == 0 ? 1e-4 : 1e-15);
  }
}

}  // namespace
}  // namespace sphk
