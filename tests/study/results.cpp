#include "src/study/results.hpp"

#include <gtest/gtest.h>

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
  EXPECT_EQ(pareto_front(results), (std::vector<bool>{true, false, true, false, false}));
}

TEST(StudyResults, TheTableIsSortedByCostWithFailuresLast) {
  std::vector<StudyResult> results{result("slow", 1, 0.1, 16), result("broken", 1, 0, 0), result("quick", 1, 0.4, 1)};
  results[1].failure = "a clear sentence";
  const std::string text = study_table(results, "v");
  const auto at = [&](const char* word) { return text.find(word); };
  EXPECT_LT(at("quick"), at("slow"));
  EXPECT_LT(at("slow"), at("broken"));
  EXPECT_NE(at("failed: a clear sentence"), std::string::npos);
  EXPECT_NE(at("L1(v)"), std::string::npos);
}

}  // namespace
}  // namespace sphk
