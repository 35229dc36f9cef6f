// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/smooth_layers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace sphk {
namespace {

double profile(double y) {
  return 1 + 9 * arctan_step(0.25 - std::abs(y - 0.5), 0.1);
}

// V10 eq 16-20: 0, 1/2 and 1 at the edges and the middle, odd about it, and A atan(B (y + C)) in between: a quarter of
// the width above the middle the argument is beta/2.
TEST(ArctanStep, IsV10s) {
  EXPECT_EQ(arctan_step(-0.06, 0.1), 0);
  EXPECT_NEAR(arctan_step(-0.05, 0.1), 0, 1e-12);
  EXPECT_NEAR(arctan_step(0, 0.1), 0.5, 1e-15);
  EXPECT_NEAR(arctan_step(0.025, 0.1), 0.5 + 0.5 * std::atan(5.0) / std::atan(10.0), 1e-15);
  EXPECT_NEAR(arctan_step(0.01, 0.1, 4) + arctan_step(-0.01, 0.1, 4), 1, 1e-15);
}

// Equal masses on a column between two heights are the mass between them, to one particle.
TEST(Columns, FollowTheDensity) {
  const auto x = columns_of(profile, {0, 0, 0}, {1, 1, 1}, 10, 550);
  ASSERT_EQ(x.size(), 5500u);
  for (const double y : {0.1, 0.2, 0.24, 0.3, 0.5}) {
    double mass = 0;  // by a fine sum; 550 particles stand for 1 + 9/2
    for (int k = 0; k < 100000; ++k) mass += profile((k + 0.5) * y / 100000) * y / 100000;
    const auto below = std::ranges::count_if(x, [&](const Array3& p) { return p[1] < y && p[0] < 0.1; });
    EXPECT_NEAR(double(below), mass * 100, 1.01) << y;
  }
}

// On rows: as many particles as were asked for, to one row; rows of one y, evenly filled; and m = rho dx dy with dx =
// dy: the distance of two rows of n particles is 1/n, to the rounding of n.
TEST(Rows, AreSquaresOfTheMass) {
  const double wanted = 20000;
  std::map<double, int> rows;
  const auto smooth = [](double y) { return 5.5 - 4.5 * std::cos(2 * M_PI * y); };  // 1 to 10 and back
  for (const Array3& x : rows_of(smooth, {0, 0, 0}, {1, 1, 1}, wanted)) ++rows[x[1]];
  double total = 0, least = 1e9;
  for (const auto& [y, n] : rows) total += n, least = std::min(least, double(n));
  EXPECT_NEAR(total, wanted, 200);
  EXPECT_NEAR(least, std::sqrt(wanted / 5.5), 1) << "the light gas: rho = 1 of a mean of 5.5";
  for (auto row = rows.begin(); std::next(row) != rows.end(); ++row) {
    const auto next = std::next(row);
    const double mean = 0.5 / row->second + 0.5 / next->second;
    EXPECT_NEAR(next->first - row->first, mean, 0.06 * mean) << row->first;
  }
}

}  // namespace
}  // namespace sphk
