// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "src/engine/errors.hpp"
#include "tests/scenes/engine_keys.hpp"

namespace sphk {
namespace {

// 64^3 particles in the unit box (Saitoh & Makino 2009), one of which carries E = 1 and sits on the centre.
TEST(PointExplosion, OneParticleHasTheEnergy) {
  const ParticleSet gas = point_explosion_scene.build(settings_of(point_explosion_scene));
  ASSERT_EQ(gas.size(), 64u * 64 * 64);
  EXPECT_TRUE(inside_box(gas));
  int hot = 0;
  for (std::size_t i = 0; i < gas.size(); ++i) {
    if (gas.u[i] == 1e-6) continue;
    ++hot;
    EXPECT_NEAR(gas.m[i] * gas.u[i], 1, 1e-11);  // and u = 1e-6 of its own
    EXPECT_EQ(gas.x[i], (Array3{0, 0, 0}));
  }
  EXPECT_EQ(hot, 1);
}

TEST(PointExplosion, TakesOtherEnergiesAndDimensions) {
  const ParticleSet gas = point_explosion_scene.build(
      settings_of(point_explosion_scene,
                  {{"scene.n", "15"}, {"scene.dimension", "2"}, {"scene.energy", "3"}, {"scene.ambient", "0.01"}}));
  double energy = 0;
  for (std::size_t i = 0; i < gas.size(); ++i) energy += gas.m[i] * gas.u[i];
  EXPECT_NEAR(energy, 3.01, 1e-13);
  EXPECT_TRUE(inside_box(gas));
}

// Shells of a cubic lattice by distance: 1, 6, 12, 8 in 3D; 1, 4, 4 in 2D; 1, 2, 2 in 1D. Their sum over each axis is
// 0.
TEST(PointExplosion, WholeShellsShareTheEnergy) {
  const std::pair<int, std::vector<int>> numbers[] = {{1, {1, 3, 5}}, {2, {1, 5, 9}}, {3, {1, 7, 15, 19, 27}}};
  for (const auto& [D, counts] : numbers)
    for (const int count : counts) {
      const ParticleSet gas = point_explosion_scene.build(settings_of(
          point_explosion_scene,
          {{"scene.n", "16"}, {"scene.dimension", std::to_string(D)}, {"scene.hot", std::to_string(count)}}));
      int hot = 0;
      double energy = 0;
      Array3 centre{};
      for (std::size_t i = 0; i < gas.size(); ++i) {
        if (gas.u[i] == 1e-6) continue;
        ++hot;
        energy += gas.m[i] * (gas.u[i] - 1e-6);
        for (int axis = 0; axis < 3; ++axis) {
          EXPECT_LE(std::abs(gas.x[i][axis]), (D == 1 ? 2 : 1) / 16.0 + 1e-12) << D << ' ' << count;
          centre[axis] += gas.x[i][axis];
        }
      }
      EXPECT_EQ(hot, count) << D;
      EXPECT_NEAR(energy, 1, 1e-12);
      for (const double s : centre) EXPECT_NEAR(s, 0, 1e-14) << D << ' ' << count;
    }
}

TEST(PointExplosion, RefusesNumbersThatBreakAShell) {
  for (const char* count : {"2", "6", "8", "13", "16", "5000"})
    EXPECT_THROW(
        point_explosion_scene.build(settings_of(point_explosion_scene, {{"scene.n", "16"}, {"scene.hot", count}})),
        InputError)
        << count;
}

// The shock of E = 1 stands at 1.15 t^(2/5) = 0.347 at t = 0.05, ahead of it the cold gas with P = (gamma - 1) u.
TEST(PointExplosion, HasSedovsSolution) {
  const auto exact = point_explosion_scene.exact(settings_of(point_explosion_scene));
  EXPECT_NEAR(exact({0, 0.36, 0}, 0.05).P, 2e-6 / 3, 1e-20);
  EXPECT_GT(exact({0, 0.34, 0}, 0.05).rho, 2.5);
  EXPECT_GT(exact({0, 0.34, 0}, 0.05).v[1], 0);
}

}  // namespace
}  // namespace sphk
