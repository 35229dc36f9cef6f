// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/fma_peak.hpp"

#include <gtest/gtest.h>

namespace sphk {
namespace {

// What any processor of today lies between: one scalar FMA every 10 ns, and 1000 of the fastest cores of 2026.
TEST(FmaPeak, IsAPlausibleRate) {
  const FmaPeak peak = measure_fma_peak();
  EXPECT_GT(peak.single, 2e8);
  EXPECT_LT(peak.single, 1e15);
  // A register holds twice as many floats as doubles where it holds several, else equally many; the rest is timing
  // noise.
  EXPECT_GT(peak.single / peak.twofold, 0.5);
  EXPECT_LT(peak.single / peak.twofold, 4);
}

TEST(FmaPeak, OfAPrecisionIsThatOfItsPairArithmetic) {
  const FmaPeak peak{.single = 2, .twofold = 1};
  EXPECT_EQ(peak.of("mixed"), 2);
  EXPECT_EQ(peak.of("double"), 1);
}

}  // namespace
}  // namespace sphk
