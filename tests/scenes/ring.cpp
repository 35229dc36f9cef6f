// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/scenes/engine_keys.hpp"

namespace sphk {
namespace {

// Of a ring that is cut at three widths: 2 pi R0 w sqrt(2 pi) erf(3/sqrt 2), to half a particle.
TEST(Ring, MassIsTheProfiles) {
  const double mass = 2 * std::numbers::pi * 0.125 * std::sqrt(2 * std::numbers::pi) * std::erf(3 / std::sqrt(2.0));
  for (const int n : {32, 64, 128}) {
    const Settings settings = settings_of(ring_scene, {{"scene.n", std::to_string(n)}});
    EXPECT_NEAR(total_mass(ring_scene.build(settings)), mass, 0.51 / (n * n)) << n;
  }
}

// As many particles on each circle as the density wants: their number within R follows the mass within R.
TEST(Ring, ParticlesFollowTheProfile) {
  const Settings settings = settings_of(ring_scene, {{"scene.n", "128"}});
  const ParticleSet gas = ring_scene.build(settings);
  double within = 0;
  for (const Array3& x : gas.x) within += std::hypot(x[0], x[1]) < 1;
  // integral of R exp(-(R - 1)^2/(2 w^2)) from 1 - 3 w to 1 and to 1 + 3 w, whose odd parts are -+ w^2 (1 - e^-4.5)
  const double w = 0.125, even = w * std::sqrt(std::numbers::pi / 2) * std::erf(3 / std::sqrt(2.0));
  const double odd = w * w * (1 - std::exp(-4.5));
  EXPECT_NEAR(within / double(gas.size()), (even - odd) / (2 * even), 0.01);  // half a circle's share
}

// v^2/R = G M R/(R^2 + e^2)^(3/2) + P'/rho with P = (gamma - 1) u rho, by central differences.
TEST(Ring, RotationBalancesGravityAndPressure) {
  const Settings settings =
      settings_of(ring_scene, {{"scene.mach", "10"}, {"gravity.central_mass", "3"}, {"gravity.softening", "0.5"}});
  const auto exact = ring_scene.exact(settings);
  const double d = 1e-6;
  for (const double R : {0.8, 0.93, 1.0, 1.11, 1.25}) {
    const GasState here = exact({R, 0, 0}, 0);
    const double slope = (exact({R + d, 0, 0}, 0).P - exact({R - d, 0, 0}, 0).P) / (2 * d);
    const double gravity = 3 * R / std::pow(R * R + 0.25, 1.5);
    EXPECT_NEAR(here.v[1] * here.v[1] / R, gravity + slope / here.rho, 1e-7) << R;
  }
  const GasState middle = exact({0, 1, 0}, 0);
  EXPECT_NEAR(std::sqrt(settings.real("sph.gamma") * middle.P / middle.rho), std::sqrt(3.0) / 10, 1e-12);
}

TEST(Ring, WidthIsThatOfTheStart) {
  const Settings settings = settings_of(ring_scene);
  const auto start = start_snapshot(ring_scene.build(settings), 5.0 / 3, [](const Array3&) { return 1.0; });
  const auto measures = ring_scene.measures(settings, start);
  EXPECT_EQ(measures[0].first, "ring_radius");
  EXPECT_NEAR(measures[0].second, 1, 2e-3);
  EXPECT_NEAR(measures[1].second, 1, 1e-2);
}

}  // namespace
}  // namespace sphk
