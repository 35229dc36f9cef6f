// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "tests/smoothing/kernels.hpp"

namespace sphk {
namespace {

template <class Kernel>
struct Smoothing : testing::Test {
  Kernel kernel;
  Shape<double> own(double q) const { return with_own_derivative(kernel, q); }
};
TYPED_TEST_SUITE(Smoothing, AllKernels);

TYPED_TEST(Smoothing, VanishesOutsideTheSupport) {
  for (const double q : {1.0, 1.5, 1e6, 1e30}) {
    const Shape<double> shape = this->kernel(q);
    EXPECT_EQ(shape.w, 0) << q;
    EXPECT_EQ(shape.dw, 0) << q;
    EXPECT_EQ(this->kernel.w(q), 0) << q;
    EXPECT_EQ(this->own(q).dw, 0) << q;
  }
}

TYPED_TEST(Smoothing, IsPositiveAndFallsInside) {
  for (double q = 0.001; q < 1; q += 0.001) {
    EXPECT_GT(this->kernel.w(q), 0) << q;
    EXPECT_LT(this->kernel(q).dw, 0) << q;
    EXPECT_LT(this->kernel.w(q), this->kernel.w(q - 0.001)) << q;
  }
}

// 1 = integral of N / h^D w(r/h) over the ball of radius h: Simpson between knots in r, so that w is a polynomial of
// degree 11 at most in every panel; 1000 intervals leave (1/1000)^4 / 180 of the fourth derivative, below 1e-10.
TYPED_TEST(Smoothing, ItsNormMakesTheIntegralOne) {
  constexpr double pi = 3.14159265358979323846;
  const double h = 0.37, spheres[] = {2, 2 * pi, 4 * pi};
  for (int D = 1; D <= 3; ++D) {
    const auto shell = [&](double r) {
      const double W = this->kernel.norm(D) / std::pow(h, D) * this->kernel.w(r / h);
      return W * spheres[D - 1] * std::pow(r, D - 1);
    };
    std::vector<double> edges{0};
    for (const double knot : Knots<TypeParam>::at()) edges.push_back(h * knot);
    edges.push_back(h);
    double integral = 0;
    for (std::size_t p = 1; p < edges.size(); ++p) integral += simpson(shell, edges[p - 1], edges[p], 1000);
    EXPECT_NEAR(integral, 1, 1e-10) << "in " << D << "D";
  }
}

// Central differences with step d leave d^2 w'''/6, and rounding leaves 1e-16/d; |w'''| < 4000 for every kernel.
TYPED_TEST(Smoothing, ItsOwnDerivativeIsTheSlopeOfTheShape) {
  const double d = 1e-6;
  for (double q = 0.00537; q < 1; q += 0.00931)
    EXPECT_NEAR(this->own(q).dw, (this->kernel.w(q + d) - this->kernel.w(q - d)) / (2 * d), 2e-9) << q;
}

// At a knot the differences are one-sided, of second order.
TYPED_TEST(Smoothing, ShapeAndSlopeAreContinuousAtTheKnots) {
  const double d = 1e-5;
  for (const double q : Knots<TypeParam>::at())
    for (const double side : {-d, d}) {
      const double w0 = this->kernel.w(q), w1 = this->kernel.w(q + side), w2 = this->kernel.w(q + 2 * side);
      EXPECT_NEAR((-3 * w0 + 4 * w1 - w2) / (2 * side), this->own(q).dw, 2e-6) << q << ' ' << side;
      EXPECT_NEAR(this->own(q + side).dw, this->own(q).dw, 40 * d) << q << ' ' << side;
    }
}

TYPED_TEST(Smoothing, ShapeAloneEqualsShapeWithSlope) {
  for (double q = 0; q < 1.2; q += 0.0173) {
    EXPECT_NEAR(this->kernel.w(q), this->kernel(q).w, 1e-14) << q;
    EXPECT_NEAR(this->kernel.w(q), this->own(q).w, 1e-14) << q;
  }
}

/// The largest difference of pack lanes from double scalars, in units of w(0) and of the largest slope.
template <class P, class Kernel>
double largest_difference(const Kernel& kernel) {
  using R = lane_t<P>;
  double largest = 0;
  for (double start = 0; start < 1.2; start += 0.0371) {
    R q[lanes<P>], w[lanes<P>], dw[lanes<P>];
    for (int lane = 0; lane < lanes<P>; ++lane) q[lane] = R(start + 0.0023 * lane);
    const Shape<P> shape = kernel(load<P>(q));
    store(w, shape.w);
    store(dw, shape.dw);
    for (int lane = 0; lane < lanes<P>; ++lane) {
      const Shape<double> exact = kernel(double(q[lane]));
      largest = std::max({largest, std::abs(double(w[lane]) - exact.w), std::abs(double(dw[lane]) - exact.dw) / 4});
    }
  }
  return largest;
}

// The sums of truncated powers have terms up to 9 times their result (HOCT8's slope): 64 roundings cover it.
TYPED_TEST(Smoothing, PacksAndFloatsAgreeWithDoubles) {
  const double eps = std::numeric_limits<double>::epsilon(), eps_f = std::numeric_limits<float>::epsilon();
  EXPECT_LT((largest_difference<simd<double, native_lanes<double>>>(this->kernel)), 64 * eps);
  EXPECT_LT((largest_difference<simd<float, native_lanes<float>>>(this->kernel)), 64 * eps_f);
  EXPECT_LT((largest_difference<float>(this->kernel)), 64 * eps_f);
}

}  // namespace
}  // namespace sphk
