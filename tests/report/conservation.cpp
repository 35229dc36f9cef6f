// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/conservation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sphk {
namespace {

Totals totals(double kinetic, double thermal, Array3 momentum) {
  Totals t;
  t.mass = 2;
  t.kinetic = kinetic;
  t.thermal = thermal;
  t.momentum = momentum;
  return t;
}

TEST(Conservation, NoChangeIsNoDrift) {
  const Totals t = totals(1, 2, {3, 0, 0});
  const Conservation c = drift(t, t, {});
  EXPECT_EQ(c.energy, 0);
  EXPECT_EQ(c.momentum, 0);
  EXPECT_EQ(c.angular_momentum, 0);
  EXPECT_EQ(c.mass, 0);
}

TEST(Conservation, EnergyAndMassAreRelativeToTheStart) {
  Totals now = totals(1, 4, {});
  now.mass = 2.5;
  const Conservation c = drift(totals(2, 2, {}), now, {});
  EXPECT_DOUBLE_EQ(c.energy, 0.25);  // from 4 to 5
  EXPECT_DOUBLE_EQ(c.mass, 0.25);
}

TEST(Conservation, EnergyIsRelativeToItsPartsWhichMayCancel) {
  Totals start = totals(3, 1, {}), now = totals(3.5, 1, {});
  start.potential = now.potential = -4;  // the sum is 0
  EXPECT_DOUBLE_EQ(drift(start, now, {}).energy, 0.5 / 8);
}

TEST(Conservation, MomentaAreRelativeToTheSumOfTheirSizes) {
  Totals start = totals(1, 4, {0, 0, 0}), now = totals(1, 4, {3, 4, 0});
  start.momentum_sizes = 50, now.momentum_sizes = 40;
  start.angular_momentum_sizes = 10, now.angular_momentum_sizes = 20;
  now.angular_momentum = {0, 0, 2};
  const Conservation c = drift(start, now, {});
  EXPECT_DOUBLE_EQ(c.momentum, 5.0 / 50);
  EXPECT_DOUBLE_EQ(c.angular_momentum, 2.0 / 20);
  EXPECT_FALSE(c.momentum_of_start || c.angular_momentum_of_start) << "they start at zero";
}

TEST(Conservation, MomentaThatAreThereAtTheStartAreAlsoTheirOwnScale) {
  Totals start = totals(1, 4, {40, 0, 0}), now = totals(1, 4, {44, 0, 0});
  start.momentum_sizes = now.momentum_sizes = 400;
  const Conservation c = drift(start, now, {});
  EXPECT_DOUBLE_EQ(c.momentum, 0.01);
  ASSERT_TRUE(c.momentum_of_start);
  EXPECT_DOUBLE_EQ(*c.momentum_of_start, 0.1);
}

TEST(Conservation, RoundingInGasAtRestIsNoDrift) {
  Totals now = totals(0, 4, {1e-16, 0, 0});
  now.momentum_sizes = 1e-15;
  now.angular_momentum = {0, 0, 2e-16};
  now.angular_momentum_sizes = 3e-15;
  Box box;
  box.size = {1, 5, 1};
  const double of_heat = std::sqrt(2 * 2 * 4.0);
  EXPECT_DOUBLE_EQ(drift(totals(0, 4, {}), now, box).momentum, 1e-16 / (1e-6 * of_heat));
  EXPECT_DOUBLE_EQ(drift(totals(0, 4, {}), now, box).angular_momentum, 2e-16 / (1e-6 * of_heat * 5));
}

TEST(Conservation, AnEmptySystemGivesNoNan) {
  EXPECT_EQ(drift({}, {}, {}).momentum, 0);
  EXPECT_EQ(drift({}, {}, {}).mass, 0);
}

}  // namespace
}  // namespace sphk
