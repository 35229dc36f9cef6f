// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/quantity.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace sphk {
namespace {

TEST(Quantity, NumbersTakeThreeDigitsAndAPrefix) {
  EXPECT_EQ(with_prefix(0), "0");
  EXPECT_EQ(with_prefix(999), "999");
  EXPECT_EQ(with_prefix(1000), "1.00 k");
  EXPECT_EQ(with_prefix(512345), "512 k");
  EXPECT_EQ(with_prefix(99960), "100 k");
  EXPECT_EQ(with_prefix(999900), "1.00 M");  // not "1000 k"
  EXPECT_EQ(with_prefix(9.41e10), "94.1 G");
}

TEST(Quantity, BytesGoByPowersOf1024) {
  EXPECT_EQ(bytes_text(100), "100 B");
  EXPECT_EQ(bytes_text(1536), "1.50 KiB");
  EXPECT_EQ(bytes_text(3.0 * 1024 * 1024 * 1024), "3.00 GiB");
}

TEST(Quantity, DurationsReadAsPeopleSayThem) {
  EXPECT_EQ(duration_text(0.417), "0.42 s");
  EXPECT_EQ(duration_text(12.3), "12 s");
  EXPECT_EQ(duration_text(59.7), "1:00");
  EXPECT_EQ(duration_text(187), "3:07");
  EXPECT_EQ(duration_text(2 * 3600 + 5 * 60 + 9), "2:05:09");
  EXPECT_EQ(duration_text(std::numeric_limits<double>::infinity()), "unknown");
}

}  // namespace
}  // namespace sphk
