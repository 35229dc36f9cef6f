#include "src/report/conservation.hpp"

#include <gtest/gtest.h>

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

TEST(Conservation, MomentumOfASystemThatStartsAtRestIsMeasuredBySqrt2ME) {
  // sqrt(2 M E) = sqrt(2 * 2 * 4) = 4; |p| = 5 afterwards.
  const Conservation c = drift(totals(0, 4, {}), totals(0, 4, {3, 4, 0}), {});
  EXPECT_DOUBLE_EQ(c.momentum, 5.0 / 4);
}

TEST(Conservation, ALargeMomentumIsItsOwnScale) {
  const Conservation c = drift(totals(0, 4, {40, 0, 0}), totals(0, 4, {44, 0, 0}), {});
  EXPECT_DOUBLE_EQ(c.momentum, 0.1);
}

TEST(Conservation, AngularMomentumScalesWithTheLongestSide) {
  Totals now = totals(0, 4, {});
  now.angular_momentum = {0, 0, 2};
  Box box;
  box.size = {1, 5, 1};
  EXPECT_DOUBLE_EQ(drift(totals(0, 4, {}), now, box).angular_momentum, 2.0 / (4 * 5));
}

TEST(Conservation, AnEmptySystemGivesNoNan) {
  EXPECT_EQ(drift({}, {}, {}).momentum, 0);
  EXPECT_EQ(drift({}, {}, {}).mass, 0);
}

}  // namespace
}  // namespace sphk
