// SPDX-License-Identifier: BSD-3-Clause
#include "src/study/study_compare.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "src/engine/errors.hpp"
#include "src/study/study_record.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

using Json = nlohmann::ordered_json;

Json point(const char* n, double error, double cpu) {
  const Json run = {{"n", 8},
                    {"particles", 8},
                    {"steps", 1},
                    {"updates", 8},
                    {"pair_interactions", 80},
                    {"peak_memory_bytes", 1},
                    {"conservation", {{"energy", 0}}},
                    {"wall_seconds", cpu},
                    {"cpu_seconds", cpu},
                    {"errors", {{"v", {{"l1", error}}}}}};
  return {{"keys", {{"scene.n", n}}}, {"failure", ""}, {"spent_seconds", cpu}, {"runs", Json::array({run})}};
}

/// A study of the points n-1, n-2, ... in `folder`.
void save(const std::filesystem::path& folder, const std::vector<Json>& points) {
  std::filesystem::create_directories(folder);
  Json all = Json::object();
  for (const Json& one : points) all["n-" + one["keys"]["scene.n"].get<std::string>()] = one;
  StudyRecord{folder / "study.json", {{"machine", "a box"}, {"fixed", Json::object()}, {"norm", "v"}, {"points", all}}}
      .save();
}

TEST(StudyCompare, NamesWhatGotWorse) {
  const TemporaryFolder folder;
  const auto before = folder.path() / "before", after = folder.path() / "after";
  Json broken = point("4", 1, 1);
  broken["failure"] = "it broke";
  save(before, {point("1", 1, 1), point("2", 1, 1), point("3", 1, 1), point("4", 1, 1), point("5", 1, 1)});
  save(after, {point("1", 1.01, 0.5), point("2", 1.5, 2), point("3", 0.5, 1.25), broken});
  const StudyComparison comparison = compare_studies(before, after / "study.json", "");
  ASSERT_EQ(comparison.points.size(), 4u) << "the fifth is in one study alone";
  EXPECT_EQ(comparison.points[0].verdict, "");
  EXPECT_EQ(comparison.points[0].cpu, 0.5);
  EXPECT_EQ(comparison.points[1].verdict, "larger error");
  EXPECT_EQ(comparison.points[1].error, 1.5);
  EXPECT_EQ(comparison.points[2].verdict, "slower");
  EXPECT_EQ(comparison.points[3].verdict, "fails now: it broke");
  EXPECT_EQ(comparison.points[3].n, "4");
  EXPECT_NE(comparison.before.find("a box"), std::string::npos);
  EXPECT_THROW(compare_studies(before, folder.path(), ""), InputError);
}

}  // namespace
}  // namespace sphk
