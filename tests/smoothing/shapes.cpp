// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "kernels/smoothing/list.hpp"

namespace sphk {
namespace {

/// Largest difference of a kernel from its formula as the papers print it.
template <class Kernel>
double largest_difference(const Kernel& kernel, const std::function<double(double)>& formula) {
  double largest = 0;
  for (double q = 0; q < 1; q += 0.00371) largest = std::max(largest, std::abs(kernel.w(q) - formula(q)));
  return largest;
}

double cubic_spline(double q) {
  return q <= 0.5 ? 1 - 6 * q * q + 6 * q * q * q : 2 * std::pow(1 - q, 3);
}

TEST(Shapes, CubicSplineAndHydra) {
  EXPECT_LT(largest_difference(CubicSpline{}, cubic_spline), 1e-15 * 8);
  EXPECT_LT(largest_difference(Hydra{}, cubic_spline), 1e-15 * 8);
}

TEST(Shapes, CoreTriangleHasALinearCore) {
  const double a = 1.0 / 3;
  EXPECT_LT(largest_difference(CoreTriangle{},
                               [&](double q) {
                                 return q < a ? (-12 * a + 18 * a * a) * q + 1 + 6 * a * a - 12 * a * a * a
                                              : cubic_spline(q);
                               }),
            1e-14);
}

TEST(Shapes, BSplines) {
  const auto cut = [](double edge, double q, int n) { return q < edge ? std::pow(edge - q, n) : 0; };
  EXPECT_LT(largest_difference(BSpline<5>{},
                               [&](double q) { return cut(1, q, 4) - 5 * cut(0.6, q, 4) + 10 * cut(0.2, q, 4); }),
            1e-14);
  EXPECT_LT(
      largest_difference(BSpline<6>{},
                         [&](double q) { return cut(1, q, 5) - 6 * cut(2.0 / 3, q, 5) + 15 * cut(1.0 / 3, q, 5); }),
      1e-14);
}

TEST(Shapes, JohnsonAndWendland) {
  EXPECT_LT(largest_difference(Johnson{}, [](double q) { return std::pow(1 - q, 2); }), 1e-14);
  EXPECT_LT(largest_difference(WendlandC2{}, [](double q) { return std::pow(1 - q, 4) * (1 + 4 * q); }), 1e-14);
  EXPECT_LT(
      largest_difference(WendlandC4{}, [](double q) { return std::pow(1 - q, 6) * (1 + 6 * q + 35.0 / 3 * q * q); }),
      1e-14);
  EXPECT_LT(largest_difference(WendlandC6{},
                               [](double q) { return std::pow(1 - q, 8) * (1 + 8 * q + 25 * q * q + 32 * q * q * q); }),
            1e-14);
}

}  // namespace
}  // namespace sphk
