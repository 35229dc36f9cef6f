#include <gtest/gtest.h>

#include "tests/scenes/engine_keys.hpp"

namespace sphk {
namespace {

// 64^3 particles in the unit box (Saitoh & Makino 2009), one of which carries E = 1 and sits on the centre.
TEST(PointExplosion, OneParticleHasTheEnergy) {
  const ParticleSet gas = point_explosion_scene().build(settings_of(point_explosion_scene()));
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
  const ParticleSet gas = point_explosion_scene().build(
      settings_of(point_explosion_scene(),
                  {{"scene.n", "15"}, {"scene.dimension", "2"}, {"scene.energy", "3"}, {"scene.ambient", "0.01"}}));
  double energy = 0;
  for (std::size_t i = 0; i < gas.size(); ++i) energy += gas.m[i] * gas.u[i];
  EXPECT_NEAR(energy, 3.01, 1e-13);
  EXPECT_TRUE(inside_box(gas));
}

// The shock of E = 1 stands at 1.15 t^(2/5) = 0.347 at t = 0.05, ahead of it the cold gas with P = (gamma - 1) u.
TEST(PointExplosion, HasSedovsSolution) {
  const auto exact = point_explosion_scene().exact(settings_of(point_explosion_scene()));
  EXPECT_NEAR(exact({0, 0.36, 0}, 0.05).P, 2e-6 / 3, 1e-20);
  EXPECT_GT(exact({0, 0.34, 0}, 0.05).rho, 2.5);
  EXPECT_GT(exact({0, 0.34, 0}, 0.05).v[1], 0);
}

}  // namespace
}  // namespace sphk
