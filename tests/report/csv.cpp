// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/csv.hpp"

#include <gtest/gtest.h>

#include "src/engine/errors.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

using Words = std::vector<std::string>;

class Csv : public testing::Test {
 protected:
  CsvTable read(const std::string& text) {
    const auto path = folder.path() / "table.csv";
    std::ofstream(path) << text;
    return read_csv(path);
  }
  TemporaryFolder folder;
};

TEST_F(Csv, HasColumnsAndRowsWithTheirLines) {
  const CsvTable table = read("# a remark\n\na, b ,c\r\n1,2,3\n# another\n4,,\n5\n");
  EXPECT_EQ(table.columns, (Words{"a", "b", "c"}));
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_EQ(table.rows[0].values, (Words{"1", "2", "3"}));
  EXPECT_EQ(table.rows[0].line, 4);
  EXPECT_EQ(table.rows[1].values, (Words{"4", "", ""}));
  EXPECT_EQ(table.rows[1].line, 6);
  EXPECT_EQ(table.rows[2].values, (Words{"5"}));
}

TEST_F(Csv, WhatIsWrittenReadsBack) {
  const Words words{"sphs hoct4 442", "a, b", "he said \"no\"", "", "# no remark", "\"", "two\nlines"};
  const std::string line = csv_line(words);
  EXPECT_EQ(line.find("\"a, b\",\"he said \"\"no\"\"\",,"), std::string("sphs hoct4 442,").size()) << line;
  const CsvTable table = read(csv_line({"#", "b", "c", "d", "e", "f", "g"}) + line);
  EXPECT_EQ(table.columns[0], "#");
  ASSERT_EQ(table.rows.size(), 1u);
  Words expected = words;
  expected.back() = "two lines";  // a line is a row
  EXPECT_EQ(table.rows[0].values, expected);
}

TEST_F(Csv, WithoutALineThereIsNoTable) {
  EXPECT_TRUE(read("# nothing\n").columns.empty());
  EXPECT_TRUE(read_csv(folder.path()).columns.empty()) << "a folder opens, but has no lines";
  EXPECT_THROW(read_csv(folder.path() / "missing.csv"), InputError);
}

}  // namespace
}  // namespace sphk
