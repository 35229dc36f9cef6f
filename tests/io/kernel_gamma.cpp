// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/kernel_gamma.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace sphk {
namespace {

/// Integral of q^a (1 - q)^n over [0, 1].
double power_integral(int a, int n) {
  return std::beta(a + 1, n + 1);
}

double cubic_spline_moment(int a) {  // 2 (1-q)^3 - (1-2q)_+^3
  return 2 * power_integral(a, 3) - std::pow(0.5, a + 1) * power_integral(a, 3);
}
double wendland_c2_moment(int a) {
  return power_integral(a, 4) + 4 * power_integral(a + 1, 4);
}
double wendland_c4_moment(int a) {
  return power_integral(a, 6) + 6 * power_integral(a + 1, 6) + 35.0 / 3 * power_integral(a + 2, 6);
}

/// sigma^2 = M_(D+1) / (D M_(D-1)) with the moments M_a of the shape in closed form.
TEST(KernelGamma, HasItsClosedForms) {
  const std::pair<const char*, double (*)(int)> kernels[] = {
      {"cs", cubic_spline_moment}, {"wc2", wendland_c2_moment}, {"wc4", wendland_c4_moment}};
  for (const auto& [kernel, moment] : kernels)
    for (int D = kernel == std::string("cs") ? 1 : 2; D <= 3; ++D)  // Wendland's 1D functions are another family
      EXPECT_NEAR(kernel_gamma(kernel, D), 0.5 / std::sqrt(moment(D + 1) / (D * moment(D - 1))), 1e-12)
          << kernel << " in " << D << "D";
}

/// The numbers that SWIFT prints for the cubic spline (Dehnen & Aly 2012, table 1), 6 decimals.
TEST(KernelGamma, OfTheCubicSplineIsTheTables) {
  EXPECT_NEAR(kernel_gamma("cs", 1), 1.732051, 5e-7);
  EXPECT_NEAR(kernel_gamma("cs", 2), 1.778002, 5e-7);
  EXPECT_NEAR(kernel_gamma("cs", 3), 1.825742, 5e-7);
}

TEST(KernelGamma, UnknownKernelsAreRefused) {
  EXPECT_THROW(kernel_gamma("none", 3), std::invalid_argument);
}

}  // namespace
}  // namespace sphk
