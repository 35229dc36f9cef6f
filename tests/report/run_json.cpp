// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/run_json.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "src/engine/errors.hpp"
#include "src/report/final_table.hpp"

namespace sphk {
namespace {

RunRecord example() {
  RunRecord r;
  r.scene = "sod";
  r.particles = 1000;
  r.steps = 20;
  r.wall_seconds = 2;
  r.peak_memory_bytes = 3e6;
  r.costs.updates = 20000;
  r.costs.pair_interactions = 1e6;
  r.costs.flops = 8e7;
  r.costs.phases = {{"density", 0.5}, {"rates", 1.25}};
  r.platform.fma_peak = 1e8;
  r.errors["v"] = {.l1 = 0.03, .l2 = 0.05, .linf = 0.4, .where = {0.1, 0, 0}};
  r.left_out = {"viscosity: no shocks"};
  return r;
}

// The keys that scripts read.
TEST(RunJson, HasEveryKeyOfTheContract) {
  const auto json = nlohmann::json::parse(run_json(example()));
  for (const char* key : {"scene",
                          "scheme",
                          "kernel",
                          "neighbours",
                          "n",
                          "particles",
                          "dimension",
                          "precision",
                          "backend",
                          "threads",
                          "steps",
                          "updates",
                          "pair_interactions",
                          "wall_seconds",
                          "cpu_seconds",
                          "setup_seconds",
                          "output_seconds",
                          "seconds_by_phase",
                          "updates_per_second",
                          "peak_memory_bytes",
                          "bytes_per_particle",
                          "flops_per_second",
                          "share_of_peak",
                          "conservation",
                          "errors",
                          "left_out",
                          "warnings",
                          "version",
                          "git_revision",
                          "compiler",
                          "compiler_flags",
                          "kokkos",
                          "command",
                          "host",
                          "date",
                          "machine"})
    EXPECT_TRUE(json.contains(key)) << key;
  for (const char* key : {"energy", "momentum", "angular_momentum", "mass"})
    EXPECT_TRUE(json["conservation"].contains(key)) << key;
  for (const char* key : {"l1", "l2", "linf", "where"}) EXPECT_TRUE(json["errors"]["v"].contains(key)) << key;
}

TEST(RunJson, RatesFollowFromTheCounts) {
  const auto json = nlohmann::json::parse(run_json(example()));
  EXPECT_EQ(json["updates_per_second"], 10000.0);
  EXPECT_EQ(json["pairs_per_second"], 5e5);
  EXPECT_EQ(json["flops_per_second"], 4e7);
  EXPECT_EQ(json["share_of_peak"], 0.4);
  EXPECT_EQ(json["seconds_by_phase"]["rates"], 1.25);
  EXPECT_EQ(json["peak_memory_bytes"], 3e6);
}

TEST(RunJson, StaysValidWithNanAndStrangeText) {
  RunRecord r = example();
  r.conservation.energy = std::numeric_limits<double>::quiet_NaN();
  r.warnings = {"quote \" and byte \xff"};
  const auto json = nlohmann::json::parse(run_json(r));
  EXPECT_TRUE(json["conservation"]["energy"].is_null());
  EXPECT_EQ(json["warnings"].size(), 1u);
}

TEST(RunJson, ARunWithoutAStepDividesByNothing) {
  const auto json = nlohmann::json::parse(run_json(RunRecord{}));
  EXPECT_EQ(json["updates_per_second"], 0.0);
  EXPECT_EQ(json["share_of_peak"], 0.0);
}

TEST(RunJson, ReadAgainGivesTheSameFinalTable) {
  RunRecord r = example();
  r.joules = 12.5;
  r.cpu_seconds = 1.5;
  r.conservation.energy = 1e-5;
  r.deviations["M"].at.push_back({1.5, 0.1, 0.09, 0.12});
  r.deviations["cloud_mass"] = {.at = {{1, 0.5, 0.4, 0.6}}, .over_start = true};
  r.budget = ErrorBudget{
      .all = {1000, 0.1, 0.2, 0.3}, .boundary = {}, .bulk = {900, 0.05, 0.1, 0.2}, .R = 0.01, .epsilon = 0.02};
  r.warnings = {"look here"};
  EXPECT_EQ(final_table(read_run_json(run_json(r), "run.json")), final_table(r));
  EXPECT_THROW(read_run_json("{", "run.json"), InputError);
  EXPECT_THROW(read_run_json("{}", "run.json"), InputError);
}

}  // namespace
}  // namespace sphk
