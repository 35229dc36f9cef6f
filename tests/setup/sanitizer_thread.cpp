// SPDX-License-Identifier: BSD-3-Clause

// What the thread preset is for: a loop whose threads add to one number without a word is reported, a reduction is not.
#include <gtest/gtest.h>

#include <Kokkos_Core.hpp>

namespace sphk::test {
namespace {

using Number = Kokkos::View<int>;

using Teams = Kokkos::TeamPolicy<Kokkos::Schedule<Kokkos::Dynamic>>;

struct Race {
  Number sum;
  KOKKOS_FUNCTION void operator()(int i) const { sum() += i; }
  KOKKOS_FUNCTION void operator()(const Teams::member_type& team) const { sum() += team.league_rank(); }
};

struct Sum {
  KOKKOS_FUNCTION void operator()(int i, int& sum) const { sum += i; }
};

class Sanitizer : public testing::Test {
 protected:
  Sanitizer() { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};
using SanitizerDeathTest = Sanitizer;

template <class Policy>
void race_and_leave(Policy policy) {
  Kokkos::parallel_for("race", policy, Race{Number("sum")});
  Kokkos::fence();
  std::exit(0);
}

TEST_F(SanitizerDeathTest, CatchesARace) {
  EXPECT_EXIT(race_and_leave(Kokkos::RangePolicy<>(0, 100000)), testing::ExitedWithCode(66), "data race");
}

TEST_F(SanitizerDeathTest, CatchesARaceOfTeams) {
  EXPECT_EXIT(race_and_leave(Teams(3000000, 1)), testing::ExitedWithCode(66), "data race");
}

TEST_F(SanitizerDeathTest, DoesNotTakeAReductionForOne) {
  EXPECT_EXIT(
      {
        int sum = 0;
        Kokkos::parallel_reduce("sum", 100000, Sum{}, sum);
        std::exit(sum == 0);
      },
      testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace sphk::test
