// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/deviations.hpp"

#include <gtest/gtest.h>

namespace sphk {
namespace {

TEST(Deviations, AreDistancesOverTheMiddles) {
  Deviations deviations({{"M", 1, 0.1, 0.1}, {"M", 2, 0.2, 0.4}, {"M", 3, 0.5, 0.5}});
  deviations.add(0, {{"M", 7}});
  deviations.add(1, {{"W", 1}, {"M", 0.13}});         // 0.03 from 0.1
  deviations.add(1.5, {{"M", 9}});                    // no reference has this time
  deviations.add(2 + 1e-9, {{"W", 1}, {"M", 0.45}});  // 0.05 above 0.2 to 0.4
  const Deviation& M = deviations.by_measure().at("M");
  EXPECT_EQ(M.at.size(), 2u) << "the run has not reached t = 3";
  EXPECT_NEAR(M.l1(), (0.03 + 0.05) / (0.1 + 0.3), 1e-14);
  EXPECT_EQ(deviations.by_measure().size(), 1u);
}

TEST(Deviations, CanBeOfTheShareOfTheStart) {
  Deviations deviations({{"cloud", 1, 0.4, 0.6, true}});
  deviations.add(0, {{"cloud", 0.8}});
  deviations.add(1, {{"cloud", 0.24}});
  EXPECT_TRUE(deviations.by_measure().at("cloud").over_start);
  EXPECT_NEAR(deviations.by_measure().at("cloud").at[0].value, 0.3, 1e-15);
  EXPECT_NEAR(deviations.by_measure().at("cloud").l1(), 0.1 / 0.5, 1e-15);
}

TEST(Deviations, WantEveryTimeOfTheRunOnce) {
  const Deviations deviations({{"M", 2, 1, 1}, {"W", 1, 1, 1}, {"W", 2, 1, 1}, {"W", 3, 1, 1}, {"M", 4, 1, 1}});
  EXPECT_EQ(deviations.times(1, 3), (std::vector<double>{2, 3}));
}

}  // namespace
}  // namespace sphk
