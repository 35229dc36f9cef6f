// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/progress.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace sphk {
namespace {

/// What `write` prints into a file that is no terminal.
template <class F>
std::string printed(F write) {
  std::FILE* file = std::tmpfile();
  write(file);
  std::rewind(file);
  std::string text(4096, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file));
  std::fclose(file);
  return text;
}

StepReport example() {
  StepReport step;
  step.step = 7, step.time = 0.05, step.dt = 2.5e-3;
  step.min_neighbours = 40, step.mean_neighbours = 48.5, step.max_neighbours = 61;
  step.limiting_id = 1234, step.limiting_x = {0.25, 0.5, 0.75};
  return step;
}

TEST(Progress, IsLinesWhereThereIsNoTerminal) {
  std::FILE* file = std::tmpfile();
  EXPECT_EQ(style_for(file), ProgressStyle::lines);
  std::fclose(file);
}

TEST(Progress, ALineTellsWhereTheRunIsAndWhatLimitsIt) {
  const std::string text = printed([](std::FILE* file) {
    Progress(ProgressStyle::lines, {.from = 0, .to = 0.2}, file).report(example(), 7000, 1.5e-6);
  });
  for (const char* part : {"step      7", "t 0.05 of 0.2", "dt 2.500e-03", "updates/s", "neighbours 40/48.5/61",
                           "energy drift 1.50e-06", "left", "#1234 at (0.25, 0.5, 0.75)"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in " << text;
  EXPECT_EQ(text.find('\r'), std::string::npos);
  EXPECT_EQ(text.back(), '\n');
}

TEST(Progress, AJsonLogIsOneObjectALine) {
  const std::string text = printed([](std::FILE* file) {
    Progress progress(ProgressStyle::json, {.from = 0, .to = 0.2}, file);
    progress.say("hello \"you\"");
    progress.report(example(), 7000, 1.5e-6);
  });
  const auto end = text.find('\n');
  EXPECT_EQ(nlohmann::json::parse(text.substr(0, end))["message"], "hello \"you\"");
  const auto json = nlohmann::json::parse(text.substr(end + 1));
  EXPECT_EQ(json["step"], 7);
  EXPECT_EQ(json["limiting_id"], 1234);
  EXPECT_EQ(json["neighbours"][2], 61.0);
}

TEST(Progress, TheBarShowsThePartThatIsDone) {
  const std::string text = printed(
      [](std::FILE* file) { Progress(ProgressStyle::bar, {.from = 0, .to = 0.1}, file).report(example(), 7000, 0); });
  EXPECT_NE(text.find("[##########..........]  50 %"), std::string::npos) << text;  // t = 0.05 of 0.1, 20 characters
  EXPECT_EQ(text.back(), '\n');                                                     // the bar is closed at the end
}

TEST(Progress, ALimitOfStepsCountsAsProgressToo) {
  const std::string text = printed([](std::FILE* file) {
    Progress(ProgressStyle::bar, {.from = 0, .to = 1e9, .steps = 28}, file).report(example(), 7000, 0);
  });
  EXPECT_NE(text.find("[#####...............]  25 %"), std::string::npos) << text;
}

TEST(Progress, IsDueAtTheFirstStepAndThenNotAtOnce) {
  printed([](std::FILE* file) {
    Progress progress(ProgressStyle::lines, {}, file);
    EXPECT_TRUE(progress.due());
    progress.report(example(), 1, 0);
    EXPECT_FALSE(progress.due());
  });
}

}  // namespace
}  // namespace sphk
