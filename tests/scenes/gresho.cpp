// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenes/engine_keys.hpp"

namespace sphk {
namespace {

// S12 sec 7.3: N x N x N/8, density 1.
TEST(Gresho, CountsAreTheThinSlabs) {
  const auto count = [](std::vector<std::pair<std::string, std::string>> keys) {
    return gresho_scene.build(settings_of(gresho_scene, keys));
  };
  const ParticleSet gas = count({{"scene.n", "32"}});
  EXPECT_EQ(gas.size(), 32u * 32 * 4);
  EXPECT_EQ(gas.box.size, (Array3{1, 1, 0.125}));
  EXPECT_NEAR(total_mass(gas), 0.125, 1e-13);
  EXPECT_EQ(count({{"scene.n", "32"}, {"scene.layers", "8"}}).size(), 32u * 32 * 8);
  EXPECT_EQ(count({{"scene.n", "32"}, {"scene.dimension", "2"}}).size(), 32u * 32);
  EXPECT_NEAR(total_mass(count({{"scene.n", "32"}, {"scene.dimension", "2"}})), 1, 1e-13);
}

// S12 eq 45 and 46: v_phi(0.1) = 0.5, v_phi(0.3) = 0.5; P(0) = 5, P(R > 0.4) = 3 + 4 ln 2.
TEST(Gresho, StatesArePrintedOnes) {
  const auto exact = gresho_scene.exact(settings_of(gresho_scene));
  EXPECT_NEAR(exact({0.1, 0, 0}, 0).v[1], 0.5, 1e-15);
  EXPECT_NEAR(exact({0, -0.3, 0}, 3).v[0], 0.5, 1e-15);
  EXPECT_EQ(exact({0, 0, 0}, 0).P, 5);
  EXPECT_NEAR(exact({0.3, 0.4, 0}, 0).P, 3 + 4 * std::log(2.0), 1e-15);
}

// dP/dR = rho v^2 / R, by central differences; at the bends 0.2 and 0.4 they leave d/2 times a jump of 50 in d2P/dR2.
TEST(Gresho, PressureBalancesTheRotation) {
  const auto exact = gresho_scene.exact(settings_of(gresho_scene));
  const double d = 1e-6;
  for (const double R : {0.07, 0.15, 0.2, 0.27, 0.33, 0.4, 0.45}) {
    const double slope = (exact({R + d, 0, 0}, 0).P - exact({R - d, 0, 0}, 0).P) / (2 * d);
    const double v = exact({R, 0, 0}, 0).v[1];
    EXPECT_NEAR(slope, v * v / R, 3e-5) << R;
  }
}

// Two states that are compared bin by bin: half the speed is off by half the mean speed over R in [0, 0.5], which is
// (1/2) (0.1 + 0.1)/0.5 = 0.2.
TEST(Gresho, NormIsTheMeanOverRadialBins) {
  const Settings settings = settings_of(gresho_scene, {{"scene.n", "256"}, {"scene.layers", "1"}});
  const auto exact = gresho_scene.exact(settings);
  const auto slowed = snapshot_of(gresho_scene.build(settings), 1, [&](const Array3& x) {
    GasState state = exact(x, 1);
    for (double& v : state.v) v /= 2;
    return state;
  });
  EXPECT_NEAR(gresho_scene.errors(settings, slowed).at("v").l1, 0.2, 0.002);
}

// A boost of 1.5 takes the centre to 0.45 in 0.3, and to 1.2 and so to 0.2 in 0.8: what holds at a place of the resting
// vortex holds there, and is as much faster.
TEST(Gresho, MovesThroughTheBox) {
  const auto resting = gresho_scene.exact(settings_of(gresho_scene));
  const Settings settings = settings_of(gresho_scene, {{"scene.boost", "1.5"}, {"scene.n", "32"}});
  const auto moving = gresho_scene.exact(settings);
  for (const Array3& x : {Array3{0, 0, 0}, Array3{0.13, -0.2, 0}, Array3{-0.3, 0.1, 0.05}})
    for (const auto& [t, shift] : {std::pair{0.3, 0.45}, std::pair{0.8, 0.2}}) {
      const GasState there = moving({x[0] + shift, x[1] + shift, x[2]}, t), here = resting(x, 0);
      EXPECT_NEAR(there.P, here.P, 1e-13);
      for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(there.v[axis], here.v[axis] + (axis < 2 ? 1.5 : 0), 1e-13);
    }
  auto gas = gresho_scene.build(settings);
  for (Array3& x : gas.x)
    for (int axis = 0; axis < 2; ++axis) x[axis] = std::fmod(x[axis] + 1.2 + 0.5, 1) - 0.5;
  const auto moved = [&](const Array3& x) { return moving(x, 0.8); };
  EXPECT_NEAR(gresho_scene.errors(settings, snapshot_of(gas, 0.8, moved)).at("v_particles").linf, 0, 1e-13);
  const auto slower = [&](const Array3& x) {
    GasState state = moved(x);
    state.v[0] -= 1.5, state.v[1] -= 1.5;  // at rest: wrong by the boost along the azimuth, 1.5 sqrt(2) at most
    return state;
  };
  const double most = gresho_scene.errors(settings, snapshot_of(gas, 0.8, slower)).at("v_particles").linf;
  EXPECT_NEAR(most, 1.5 * std::sqrt(2), 0.01);
}

}  // namespace
}  // namespace sphk
