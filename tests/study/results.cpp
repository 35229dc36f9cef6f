// SPDX-License-Identifier: BSD-3-Clause
#include "src/study/results.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "src/study/study_record.hpp"

namespace sphk {
namespace {

StudyResult result(const char* method, double n, double error, double cpu) {
  StudyResult r;
  r.point.keys = {{"sph.scheme", method}, {"scene.n", std::to_string(int(n))}};
  r.n = n, r.error = error, r.cpu = cpu;
  return r;
}

// error = 3 / n^1.5
TEST(StudyResults, OrderIsTheSlope) {
  std::vector<StudyResult> results;
  for (const double n : {10.0, 20.0, 40.0}) results.push_back(result("a", n, 3 / std::pow(n, 1.5), n));
  EXPECT_NEAR(*fitted_order(results), 1.5, 1e-12);
  EXPECT_FALSE(fitted_order({results[0]})) << "one point has no slope";
  results[1].failure = "it broke", results[1].error = 99;
  EXPECT_NEAR(*fitted_order(results), 1.5, 1e-12);
}

// A slope through errors that rise somewhere says nothing of convergence.
TEST(StudyResults, ErrorsThatDoNotFallHaveNoOrder) {
  const std::vector<StudyResult> falls{result("a", 32, 0.2, 3), result("a", 8, 0.4, 1), result("a", 16, 0.3, 2)};
  EXPECT_TRUE(fitted_order(falls));
  std::vector<StudyResult> rises = falls;
  rises[0].error = 0.31;  // still below that of the coarsest run
  EXPECT_FALSE(fitted_order(rises));
  rises[0].error = 0.3;
  EXPECT_FALSE(fitted_order(rises));
  EXPECT_EQ(order_table(rises).rows.at(0).at(1), "its errors do not fall");
  EXPECT_TRUE(order_table({falls[0]}).rows.empty()) << "one resolution";
}

// 1000 updates in 2 s, 500 in 3 s: 2 ms and 6 ms an update, three times as much, in one and a half times the time.
TEST(StudyResults, CostsAreThoseBesideTheFirstMethodAtOneResolution) {
  std::vector<StudyResult> results{result("first", 8, 0.4, 0.1), result("first", 16, 0.3, 2),
                                   result("other", 16, 0.2, 3), result("third", 8, 0.2, 1), result("broken", 16, 0, 0)};
  for (StudyResult& r : results) r.updates = 1000;
  results[2].updates = 500;
  results[4].failure = "it broke";
  const std::vector<CostRatio> ratios = cost_ratios(results);
  ASSERT_EQ(ratios.size(), 2u) << "the third method has no run of the largest common resolution";
  EXPECT_EQ(ratios[0].method, "first");
  EXPECT_EQ(ratios[0].update, 1);
  EXPECT_EQ(ratios[1].method, "other");
  EXPECT_EQ(ratios[1].n, 16);
  EXPECT_NEAR(ratios[1].microseconds, 6000, 1e-9);
  EXPECT_NEAR(ratios[1].update, 3, 1e-12);
  EXPECT_NEAR(ratios[1].run, 1.5, 1e-12);
  EXPECT_TRUE(cost_ratios({results[0], results[1]}).empty()) << "nothing to compare with";
}

// Errors 0.4 and 0.1 at 1 s and 16 s: 0.2 lies half-way in both logarithms, at 4 s.
TEST(StudyResults, TimeToTargetIsInterpolatedInLogarithms) {
  const std::vector<StudyResult> runs{result("a", 2, 0.1, 16), result("a", 1, 0.4, 1)};
  const TimeToTarget half = time_to_target(runs, 0.2);
  EXPECT_EQ(half.how, TimeToTarget::How::interpolated);
  EXPECT_NEAR(half.cpu, 4, 1e-12);
  EXPECT_EQ(time_to_target(runs, 0.05).how, TimeToTarget::How::not_reached);
  EXPECT_EQ(time_to_target(runs, 0.5).how, TimeToTarget::How::at_once);
  EXPECT_EQ(time_to_target(runs, 0.5).cpu, 1);
}

TEST(StudyResults, TheFrontHoldsWhatNothingBeats) {
  std::vector<StudyResult> results{result("a", 1, 0.4, 1), result("b", 1, 0.4, 2), result("a", 2, 0.1, 16),
                                   result("b", 2, 0.2, 20), result("c", 1, 0.01, 0.5)};
  results[4].failure = "it broke";
  std::vector<bool> front;
  for (const StudyResult& r : results) front.push_back(on_front(r, results));
  EXPECT_EQ(front, (std::vector<bool>{true, false, true, false, false}));
}

// Errors 0.4 and 0.1 at 1 s and 16 s with n = 1 and 4: 0.2 and 2 at 4 s; four times the time halves the error.
TEST(StudyResults, ABudgetIsSpentOnWhatReachesTheSmallestError) {
  const std::vector<StudyResult> a{result("a", 4, 0.1, 16), result("a", 1, 0.4, 1)};
  EXPECT_NEAR(error_within(a, 4)->error, 0.2, 1e-12);
  EXPECT_NEAR(error_within(a, 4)->n, 2, 1e-12);
  EXPECT_FALSE(error_within(a, 4)->extrapolated);
  EXPECT_NEAR(error_within(a, 16)->error, 0.1, 1e-12);
  EXPECT_NEAR(error_within(a, 64)->error, 0.05, 1e-12);
  EXPECT_TRUE(error_within(a, 64)->extrapolated);
  EXPECT_FALSE(error_within(a, 0.5)) << "no run is so cheap";
  EXPECT_FALSE(error_within(a, 1000)) << "too far beyond the dearest run";
  std::vector<StudyResult> disturbed = a;
  disturbed.push_back(result("a", 0.5, 0.7, 32));  // something else ran on the machine
  EXPECT_NEAR(error_within(disturbed, 64)->error, 0.05, 1e-12);
  std::vector<StudyResult> both = a;
  both.push_back(result("b", 1, 0.3, 2));
  both.push_back(result("b", 2, 0.25, 32));
  EXPECT_EQ(best_within(both, 1)->method, "a");
  EXPECT_EQ(best_within(both, 2)->method, "a") << "0.28 by then";
  EXPECT_EQ(best_within(both, 16)->method, "a");
  both.push_back(
      result("c", 1, 0.2, 0.5));  // halves its error from half a second to one: 0.0125 by 16 s, if that lasts
  both.push_back(result("c", 2, 0.1, 1));
  EXPECT_EQ(best_within(both, 16)->method, "a");
  EXPECT_EQ(best_within(both, 1)->method, "c");
  both[2].error = 0.05;
  EXPECT_EQ(best_within(both, 2)->method, "b");
}

std::string text_of(const std::vector<std::string>& row) {
  std::string text;
  for (const auto& word : row) text += word + "|";
  return text;
}

TEST(StudyResults, OthersAreMetByTheFastestMethod) {
  const std::vector<StudyResult> results{result("a", 4, 0.1, 16), result("a", 1, 0.4, 1), result("b", 1, 0.1, 8),
                                         result("b", 2, 0.05, 80)};
  const Table table =
      others_table(results, {{"X", "slow", 0.2, 400, ""}, {"Y", "good", 0.1, 40, ""}, {"Z", "best", 0.01, 1, ""}});
  EXPECT_EQ(text_of(table.rows[0]), "X, slow|0.2|400|4|100|a|");
  EXPECT_EQ(text_of(table.rows[1]), "Y, good|0.1|40|below 8|over 5.0|b|");
  EXPECT_EQ(text_of(table.rows[2]), "Z, best|0.01|1|not reached|||");
}

// JSON has no NaN: run.json holds null in its place.
TEST(StudyResults, ANormThatIsNoNumberIsAFailure) {
  const auto run = nlohmann::ordered_json::parse(R"({"n": 8, "particles": 512, "steps": 3, "updates": 1536,
    "pair_interactions": 5e4, "peak_memory_bytes": 1e6, "wall_seconds": 2, "cpu_seconds": 1,
    "conservation": {"energy": null}, "deviations": {"mass": {"l1": null}, "M": {"l1": 0.25}},
    "measures": {"M": 0.4, "W": 0.1, "E0": null}})");
  const StudyPoint point{{{"scene.n", "8"}}};
  const StudyRecord record{"study.json", {{"points", {{point.name(), {{"runs", {run}}}}}}}};
  EXPECT_NE(record.result(point, "mass").failure.find("\"mass\" is not finite"), std::string::npos);
  EXPECT_TRUE(std::isnan(record.result(point, "M").energy_drift));
  EXPECT_TRUE(record.result(point, "M").valid());
  EXPECT_EQ(record.result(point, "M").error, 0.25);
  EXPECT_EQ(record.result(point, "M", true).error, 0.4) << "as it is, not its distance from converged runs";
  EXPECT_EQ(record.result(point, "W").error, 0.1);
  EXPECT_FALSE(record.result(point, "E0").valid());
  EXPECT_FALSE(record.result(point, "banana", true).valid());
}

TEST(StudyResults, TheTableIsSortedByCostWithFailuresLast) {
  std::vector<StudyResult> results{result("slow", 1, 0.1, 16), result("broken", 1, 0, 0), result("quick", 1, 0.4, 1)};
  results[1].failure = "a clear sentence";
  results[2].joules = 3, results[2].updates = 1e6;
  const Table table = study_table(results, "L1(v)");
  EXPECT_EQ(table.rows[0][0], "quick");
  EXPECT_EQ(table.rows[1][0], "slow");
  EXPECT_EQ(table.rows[2][0], "broken");
  EXPECT_EQ(table.rows[2].back(), "failed");
  const auto column = std::ranges::find(table.head, "uJ/update") - table.head.begin();
  EXPECT_EQ(table.rows[0][column], "3");
  EXPECT_EQ(table.rows[1][column], "-");
}

}  // namespace
}  // namespace sphk
