// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/mass_profile.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sphk {
namespace {

// rho = 1 + y on [0, 1]: y + y^2/2 = 1.5 f, so y = sqrt(1 + 3 f) - 1. Straight lines between cells of size d leave an
// error of d^2/8 rho'/rho = 5e-10.
TEST(MassProfile, FollowsALinearDensity) {
  const MassProfile profile([](double y) { return 1 + y; }, 0, 1);
  EXPECT_NEAR(profile.mass(), 1.5, 1e-12);
  for (const double f : {0.0, 0.1, 0.37, 0.5, 0.999, 1.0})
    EXPECT_NEAR(profile.place(f), std::sqrt(1 + 3 * f) - 1, 1e-9) << f;
}

// Density 1 below 0 and 3 above, on [-0.5, 0.5]: a quarter of the mass lies below 0, half below 1/6.
TEST(MassProfile, FollowsAJump) {
  const MassProfile profile([](double y) { return y < 0 ? 1 : 3; }, -0.5, 1);
  EXPECT_NEAR(profile.mass(), 2, 1e-12);
  EXPECT_NEAR(profile.place(0), -0.5, 1e-12);
  EXPECT_NEAR(profile.place(0.125), -0.25, 1e-12);
  EXPECT_NEAR(profile.place(0.25), 0, 1e-12);
  EXPECT_NEAR(profile.place(0.5), 1.0 / 6, 1e-12);
  EXPECT_NEAR(profile.place(1), 0.5, 1e-12);
}

}  // namespace
}  // namespace sphk
