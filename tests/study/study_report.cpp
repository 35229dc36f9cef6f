// SPDX-License-Identifier: BSD-3-Clause
#include "src/study/study_report.hpp"

#include <gtest/gtest.h>

#include "src/report/csv.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

StudyResult result(const char* n, double error, double cpu) {
  StudyResult r;
  r.point.keys = {{"sph.scheme", "sphs"}, {"scene.n", n}};
  r.error = error, r.cpu = cpu;
  return r;
}

TEST(StudyReport, NamesThePointsOfTheFront) {
  const std::vector<StudyResult> results{result("8", 0.4, 1), result("16", 0.5, 2), result("32", 0.1, 16)};
  EXPECT_EQ(names_on_front(results), (std::vector<std::string>{"scheme-sphs_n-8", "scheme-sphs_n-32"}));
}

TEST(StudyReport, TheTableHasALineAPointWithItsFailure) {
  const TemporaryFolder folder;
  std::vector<StudyResult> results{result("8", 0.125, 1), result("16", 0, 2)};
  results[0].joules = 0.5;
  results[1].failure = "no \"kernel\",\nnone";
  write_table(folder.path() / "study.csv", results);
  const CsvTable table = read_csv(folder.path() / "study.csv");
  ASSERT_EQ(table.columns.size(), 13u);
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0].values[0], "sphs");
  EXPECT_EQ(table.rows[0].values[3], "0.125");
  EXPECT_EQ(table.rows[0].values[11], "0.5");
  EXPECT_EQ(table.rows[0].values[12], "");
  EXPECT_EQ(table.rows[1].values[11], "");
  EXPECT_EQ(table.rows[1].values[12], "no \"kernel\", none");
}

}  // namespace
}  // namespace sphk
