// SPDX-License-Identifier: BSD-3-Clause

// What the debug preset is for: each of these ends the program with a report. The numbers come from the clock, so that
// no compiler sees through them.
#include <gtest/gtest.h>

#include <Kokkos_Core.hpp>
#include <chrono>
#include <limits>
#include <memory>

namespace sphk::test {
namespace {

int one() {
  return std::chrono::steady_clock::now().time_since_epoch().count() != 0;
}

class Sanitizer : public testing::Test {
 protected:
  Sanitizer() { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};
using SanitizerDeathTest = Sanitizer;

TEST_F(SanitizerDeathTest, CatchesAReadBehindTheHeap) {
  const auto numbers = std::make_unique<int[]>(8);
  EXPECT_DEATH(std::exit(numbers[std::size_t(7 + one())]), "heap-buffer-overflow");
}

TEST_F(SanitizerDeathTest, CatchesAReadOfFreedMemory) {
  auto number = std::make_unique<int>(1);
  const int* const place = number.get();
  number.reset();
  EXPECT_DEATH(std::exit(*place), "heap-use-after-free");
}

TEST_F(SanitizerDeathTest, CatchesASignedOverflow) {
  EXPECT_DEATH(std::exit(std::numeric_limits<int>::max() + one()), "signed integer overflow");
}

TEST_F(SanitizerDeathTest, CatchesAnIndexBehindAnArray) {
  int numbers[4] = {};
  EXPECT_DEATH(std::exit(numbers[3 + one()]), "index 4 out of bounds");
}

/// The last place may still stand in a register; those of the others do not.
[[gnu::noinline]] void lose_numbers() {
  static int* volatile lost;
  for (int i = 0; i < 100; ++i) lost = new int[1];
  lost = nullptr;
}

TEST_F(SanitizerDeathTest, CatchesALeak) {
  const auto leave = [] {
    lose_numbers();
    std::exit(0);
  };
  EXPECT_DEATH(leave(), "detected memory leaks");
}

TEST_F(SanitizerDeathTest, ViewBoundsAreCheckedInsideALargerAllocation) {
  const Kokkos::View<int[4][4]> numbers("numbers");
  EXPECT_DEATH(std::exit(numbers(0, 3 + one())), "out of bounds access");
}

}  // namespace
}  // namespace sphk::test
