// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/smoothing/liq.hpp"

#include <gtest/gtest.h>

namespace sphk {
namespace {

/// V10 table 1; four significant digits are printed.
struct Row {
  double x_s, A, B, C, D, E, F, norm_2d, norm_3d;
};
constexpr Row table[] = {
    {0, -0.5, 1, 0, -1, 0.5, 0.5, 4.775, 6.685},
    {0.2, -0.9766, 2.344, -1.172, -0.7813, 0.5859, 0.6, 3.490, 4.753},
    {0.3, -1.458, 3.790, -2.624, -0.2915, 0.5831, 0.65, 2.962, 3.947},
    {0.4, -2.315, 6.481, -5.556, 0.9259, 0.4630, 0.7, 2.508, 3.251},
    {0.6, -7.813, 25, -28.125, 12.5, -1.563, 0.8, 1.798, 2.168},
    {0.8, -62.5, 225, -300, 175, -37.5, 0.9, 1.300, 1.434},
};

// Rounding in the fourth digit of coefficients up to 300 leaves 0.05 * 4 in the last row; 5e-4 of the largest one.
TEST(Liq, EqualsThePrintedPolynomials) {
  for (const Row& row : table) {
    const double tolerance = 5e-4 * std::max(1.0, std::abs(row.C));
    for (double q = 0; q < 1; q += 0.01) {
      const double quartic = (((row.A * q + row.B) * q + row.C) * q + row.D) * q + row.E;
      EXPECT_NEAR(Liq(row.x_s).w(q), q < row.x_s ? row.F - q : quartic, tolerance) << row.x_s << ' ' << q;
    }
  }
}

// V10 prints the norms truncated to three decimals.
TEST(Liq, NormsAreThePrintedOnes) {
  for (const Row& row : table) {
    EXPECT_NEAR(Liq(row.x_s).norm(2), row.norm_2d, 1e-3) << row.x_s;
    EXPECT_NEAR(Liq(row.x_s).norm(3), row.norm_3d, 1e-3) << row.x_s;
  }
}

// V10 eq A1 on: value, slope and curvature vanish at 1; slope -1 and no curvature at x_s.
TEST(Liq, MeetsItsDefiningConditionsForAnyCore) {
  for (const double x_s : {0.0, 0.17, 0.3, 0.65}) {
    const Liq kernel(x_s);
    const double d = 1e-6;
    EXPECT_NEAR(kernel(x_s).dw, -1, 1e-14);
    EXPECT_NEAR((kernel(x_s + d).dw + 1) / d, 0, 1e-3) << x_s;
    EXPECT_NEAR(kernel(1 - d).dw / d, 0, 1e-3) << x_s;
    EXPECT_NEAR(kernel.w(0.0) - kernel.w(x_s), x_s, 1e-15);
  }
}

}  // namespace
}  // namespace sphk
