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

TEST(Tables, EscapeWhatHtmlWouldRead) {
  const Table table{{"a<b"}, {{"\"x\" & y"}}};
  EXPECT_NE(table.html().find("<th class=\"words\">a&lt;b</th>"), std::string::npos) << table.html();
  EXPECT_NE(table.html().find("<td class=\"words\">&quot;x&quot; &amp; y</td>"), std::string::npos) << table.html();
}

}  // namespace
}  // namespace sphk
