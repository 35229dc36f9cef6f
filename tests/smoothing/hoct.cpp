// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/smoothing/hoct.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sphk {
namespace {

struct Printed {
  double A, B, P, Q, kappa;
};

template <int n>
void expect(const Printed& row) {
  EXPECT_NEAR(Hoct<n>::A, row.A, 6e-7) << n;
  EXPECT_NEAR(Hoct<n>::B, row.B, 6e-7) << n;
  EXPECT_NEAR(Hoct<n>::P, row.P, 6e-7) << n;
  EXPECT_NEAR(Hoct<n>::Q, row.Q, 6e-7) << n;
  EXPECT_NEAR(Hoct<n>::kappa, row.kappa, 6e-7) << n;
}

// R10's table of coefficients, six decimals.
TEST(Hoct, CoefficientsAreThePrintedOnes) {
  expect<3>({2.4, -9.4, -1.805, 1.028028, 0.316667});
  expect<4>({3.2, -18.8, -2.154228, 0.981019, 0.214108});
  expect<5>({4.266667, -37.6, -2.562204, 0.962362, 0.161376});
  expect<8>({10.113580, -300.8, -3.863083, 0.941875, 0.092683});
}

template <int n>
void expect_linear_core() {
  const Hoct<n> kernel;
  for (double q = 0; q < Hoct<n>::kappa; q += 0.01) {
    EXPECT_NEAR(kernel.w(q), Hoct<n>::P * q + Hoct<n>::Q, 1e-14) << n << ' ' << q;
    EXPECT_NEAR(kernel(q).dw, Hoct<n>::P, 1e-14) << n << ' ' << q;
  }
}

TEST(Hoct, TheCoreIsTheLinePqPlusQ) {
  expect_linear_core<3>();
  expect_linear_core<4>();
  expect_linear_core<5>();
  expect_linear_core<8>();
}

// R10 eq 46 above the core, by std::pow.
TEST(Hoct, OutsideTheCoreItIsTheSumOfTruncatedPowers) {
  const auto cut = [](double edge, double q) { return q < edge ? std::pow(edge - q, 4) : 0; };
  for (double q = 0.215; q < 1; q += 0.005)
    EXPECT_NEAR(Hoct<4>{}.w(q), cut(1, q) + 3.2 * cut(0.75, q) - 18.8 * cut(0.5, q), 1e-14) << q;
}

}  // namespace
}  // namespace sphk
