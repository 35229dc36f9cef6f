// SPDX-License-Identifier: BSD-3-Clause
#include "src/tables/published.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/smoothing/list.hpp"

namespace sphk {
namespace {

TEST(Published, DigitsSayHowNearIsNear) {
  EXPECT_DOUBLE_EQ(half_last_digit("240"), 0.5);
  EXPECT_DOUBLE_EQ(half_last_digit("-1.02"), 0.005);
  EXPECT_TRUE((PublishedValue{"", "", "1.02", 1.0249}).agrees());
  EXPECT_TRUE((PublishedValue{"", "", "1.02", 1.015}).agrees());
  EXPECT_FALSE((PublishedValue{"", "", "1.02", 1.0251}).agrees());
  EXPECT_FALSE((PublishedValue{"", "", "-0.5", 0.5}).agrees());
  EXPECT_NEAR((PublishedValue{"", "", "1.02", 1.03}).difference(), 0.01, 1e-15);
}

double value(const PublishedTable& table, const std::string& row, const std::string& quantity) {
  for (const PublishedValue& v : table.values)
    if (v.row == row && v.quantity == quantity) return v.computed;
  ADD_FAILURE() << row << ' ' << quantity << " is not in " << table.key;
  return 0;
}

// V10 eq 10: at x_s the quartic has the line's value and slope -1, and no curvature; at 1 it, its slope and its
// curvature vanish. And it is what the engine's kernel gives.
TEST(Published, LiqCoefficientsMeetV10sConditions) {
  const PublishedTable table = liq_coefficients();
  for (const double x : {0.0, 0.2, 0.3, 0.4, 0.6, 0.8}) {
    const std::string row = "x_s = " + std::string(x == 0 ? "0" : std::to_string(x).substr(0, 3));
    const auto c = [&](const char* name) { return value(table, row, name); };
    const double A = c("A"), B = c("B"), C = c("C"), D = c("D"), E = c("E"), F = c("F");
    const auto f = [&](double q) { return (((A * q + B) * q + C) * q + D) * q + E; };
    const auto slope = [&](double q) { return ((4 * A * q + 3 * B) * q + 2 * C) * q + D; };
    const auto curvature = [&](double q) { return (12 * A * q + 6 * B) * q + 2 * C; };
    const double rounding = 1e-12 * std::abs(C) + 1e-13;
    EXPECT_NEAR(f(x), F - x, rounding) << x;
    EXPECT_NEAR(slope(x), -1, rounding) << x;
    EXPECT_NEAR(curvature(x), 0, rounding) << x;
    EXPECT_NEAR(f(1), 0, rounding) << x;
    EXPECT_NEAR(slope(1), 0, rounding) << x;
    EXPECT_NEAR(curvature(1), 0, rounding) << x;
    const double q = 0.5 * (1 + x);
    EXPECT_NEAR(Liq(x).w(q), f(q), rounding) << x;
  }
}

// R10 eq 47, 48 and 51 with beta = 1/2, gamma = 3/4, by hand for n = 3 (A = 0.75/0.3125) and at the core's edge.
TEST(Published, HoctParametersAreR10s) {
  const PublishedTable table = hoct_parameters();
  EXPECT_NEAR(value(table, "n = 3", "A"), 2.4, 1e-14);
  EXPECT_NEAR(value(table, "n = 3", "B"), -(1 + 2.4 * 0.5625) / 0.25, 1e-13);
  const double kappa = value(table, "n = 5", "alpha"), A = value(table, "n = 5", "A"), B = value(table, "n = 5", "B");
  EXPECT_NEAR(std::pow(1 - kappa, 3) + A * std::pow(0.75 - kappa, 3) + B * std::pow(0.5 - kappa, 3), 0, 1e-13);
}

// Half of the integral of q^2 w of (1-q)^2 (Johnson), 1/60 of q^3/3 - q^4/2 + q^5/5, as a polynomial's root.
TEST(Published, HalfMassRadiusIsThatOfAPolynomial) {
  const double q = half_mass_radius("johnson");
  EXPECT_NEAR(std::pow(q, 3) / 3 - std::pow(q, 4) / 2 + std::pow(q, 5) / 5, 1.0 / 60, 1e-7);
}

// On a cubic lattice every particle has the same density: that of the sum over the lattice with V_D h^3 n = N_n, n =
// rho/m, found here by bisection.
TEST(Published, DensitiesOfALatticeAreItsSums) {
  const PublishedTable table = density_errors(16);
  for (const auto& [kernel, neighbours] : {std::pair{"cs", 32}, std::pair{"ct", 128}}) {
    const double wanted = with_kernel(kernel, [&, N = neighbours](const auto& k) {
      const auto n_of = [&](double h) {
        double sum = 0;
        const int reach = int(h) + 1;
        for (int i = -reach; i <= reach; ++i)
          for (int j = -reach; j <= reach; ++j)
            for (int l = -reach; l <= reach; ++l)
              if (const double q = std::sqrt(double(i * i + j * j + l * l)) / h; q < 1) sum += k.w(q);
        return k.norm(3) / (h * h * h) * sum;
      };
      double low = 1, high = 5;
      for (int step = 0; step < 60; ++step) {
        const double h = 0.5 * (low + high);
        (4 * M_PI / 3 * h * h * h * n_of(h) < N ? low : high) = h;
      }
      return n_of(high);
    });
    const std::string row = std::string(kernel) + " " + std::to_string(neighbours) + " simple";
    EXPECT_NEAR(value(table, row, "rho, 95 %"), wanted, 1e-5) << row;  // float pairs
    EXPECT_NEAR(value(table, row, "rho, 5 %"), wanted, 1e-5) << row;
  }
}

}  // namespace
}  // namespace sphk
