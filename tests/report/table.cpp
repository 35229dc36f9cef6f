// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/table.hpp"

#include <gtest/gtest.h>

namespace sphk {
namespace {

TEST(Tables, SetWordsLeftAndNumbersRight) {
  const Table table{{"name", "s", "why"}, {{"a", "10", "it broke"}, {"longer", "2.5", ""}}, {0, 2}};
  EXPECT_EQ(table.text(),
            "  name      s  why\n"
            "  a        10  it broke\n"
            "  longer  2.5\n");
}

}  // namespace
}  // namespace sphk
