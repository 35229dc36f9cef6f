// SPDX-License-Identifier: BSD-3-Clause

// The search for a support radius against functions n(h) whose roots are known.
#include "kernels/passes/support_search.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sphk::test {
namespace {

using Result = SupportSearch::Result;

/// Follows a search in 3D on n(h) with derivative dn(h).
template <class N, class Slope>
Result follow(SupportSearch& search, N n, Slope dn, double neighbours, double h_max = 1e300) {
  Result result = Result::search;
  double move = 0;
  while (result == Result::search) result = search.advance<3>(n(search.h), dn(search.h), neighbours, 1e-7, h_max, move);
  return result;
}

/// An even gas has n = 1 whatever h: 4 pi/3 h^3 = N_n.
TEST(SupportSearch, FindsTheRootOfAnEvenGasFromEitherSide) {
  const double root = std::cbrt(48 * 3 / (4 * M_PI));
  for (const double start : {root / 100, root / 2, root, 3 * root, 1000 * root}) {
    SupportSearch search{start};
    EXPECT_EQ(follow(
                  search, [](double) { return 1.0; }, [](double) { return 0.0; }, 48),
              Result::found);
    EXPECT_NEAR(search.h, root, 1e-13 * root) << "from " << start;
  }
}

/// A step in the neighbour number has no root: bisection closes on the step.
TEST(SupportSearch, EndsAtAJumpByBisection) {
  SupportSearch search{1.0};
  const auto n = [](double h) { return h < 2 ? 1e-3 : 100.0; };
  const Result result = follow(
      search, n, [](double) { return 0.0; }, 48);
  EXPECT_NE(result, Result::search);
  EXPECT_TRUE(search.bisected);
  EXPECT_NEAR(search.h, 2, 1e-6);
}

TEST(SupportSearch, IsCappedWhereThereAreTooFew) {
  SupportSearch search{1.0};
  EXPECT_EQ(
      follow(
          search, [](double h) { return 1 / (h * h * h); }, [](double h) { return -3 / (h * h * h * h); }, 48, 7.0),
      Result::capped);
  EXPECT_EQ(search.h, 7.0);
}

TEST(SupportSearch, SaysCrowdedWhereCoincidentParticlesAreTooMany) {
  SupportSearch search{1.0};  // V n h^3 = 100 for every h
  const double number = 100 / (4 * M_PI / 3);
  const auto n = [&](double h) { return number / (h * h * h); };
  EXPECT_EQ(follow(
                search, n, [&](double h) { return -3 * number / (h * h * h * h); }, 48),
            Result::crowded);
}

TEST(SupportSearch, GivesUpOnWhatIsNotANumber) {
  SupportSearch search{1.0};
  EXPECT_EQ(follow(
                search, [](double) { return std::nan(""); }, [](double) { return 0.0; }, 48),
            Result::failed);
  SupportSearch lost{std::nan("")};
  EXPECT_EQ(follow(
                lost, [](double) { return 1.0; }, [](double) { return 0.0; }, 48),
            Result::failed);
}

}  // namespace
}  // namespace sphk::test
