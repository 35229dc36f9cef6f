// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/smoothing/tabulated.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/smoothing/kernels.hpp"

namespace sphk {
namespace {

template <class Kernel>
struct TabulatedKernel : testing::Test {
  Kernel kernel;
  Tabulated table{kernel};
};
TYPED_TEST_SUITE(TabulatedKernel, AllKernels);

// The slope of HOCT8 has a kink of 508 in its second derivative at kappa, and a cubic through four points of an
// interval of length d misses such a kink by less than 508 d^2 / 24 = 3e-7 there, 1e-7 of its steepest slope, 3.9.
TYPED_TEST(TabulatedKernel, FollowsTheKernel) {
  double steepest = 0;
  for (double q = 0; q < 1; q += 0.01) steepest = std::max(steepest, -this->kernel(q).dw);
  for (double q = 0; q < 1.1; q += 0.0000137) {
    ASSERT_NEAR(this->table(q).w, this->kernel(q).w, 1e-7 * this->kernel.w(0.0)) << q;
    ASSERT_NEAR(this->table(q).dw, this->kernel(q).dw, 1e-7 * steepest) << q;
    ASSERT_NEAR(this->table.with_own_derivative(q).dw, with_own_derivative(this->kernel, q).dw, 1e-7 * steepest) << q;
    ASSERT_EQ(this->table.w(q), this->table(q).w);
  }
}

TYPED_TEST(TabulatedKernel, KeepsNameAndNorm) {
  EXPECT_STREQ(this->table.name(), TypeParam::name);
  for (int D = 1; D <= 3; ++D) EXPECT_DOUBLE_EQ(this->table.norm(D), this->kernel.norm(D));
}

TEST(Tabulated, IsZeroOutsideTheSupport) {
  const Tabulated table{CubicSpline{}};
  for (const double q : {1.0, 1.5, 1e30, std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(table(q).w, 0) << q;
    EXPECT_EQ(table(q).dw, 0) << q;
  }
}

TEST(Tabulated, PackLanesReadTheirOwnRows) {
  using P = simd<float, native_lanes<float>>;
  const Tabulated table{Hoct<4>{}};
  float q[lanes<P>], w[lanes<P>];
  for (int lane = 0; lane < lanes<P>; ++lane) q[lane] = 0.07f * float(lane);
  store(w, table.w(load<P>(q)));
  for (int lane = 0; lane < lanes<P>; ++lane) EXPECT_NEAR(w[lane], Hoct<4>{}.w(double(q[lane])), 1e-6) << lane;
}

TEST(Tabulated, TakesKernelsWithParameters) {
  const Tabulated table{Liq(0.4), "liq0.4"};
  EXPECT_STREQ(table.name(), "liq0.4");
  EXPECT_NEAR(table.w(0.2), 0.5, 1e-7);  // V10 table 1: F = 0.7 at x_s = 0.4, minus q
}

}  // namespace
}  // namespace sphk
