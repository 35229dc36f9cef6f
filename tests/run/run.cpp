// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/run.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "src/engine/errors.hpp"
#include "src/io/hdf5_file.hpp"
#include "src/report/quantity.hpp"
#include "src/run/dry_run.hpp"
#include "src/run/rates.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

/// 4^3 particles on a shaken lattice, three steps.
class Run : public testing::Test {
 protected:
  RunRequest request(const std::string& name) const {
    return {.what = "uniform",
            .overrides = {{"scene.n", "4", "-n 4"},
                          {"scene.lattice", "cubic", "--set"},
                          {"scene.jitter", "0.1", "--set"},
                          {"time.max_steps", "3", "--steps 3"}},
            .out = folder.path() / name};
  }
  TemporaryFolder folder;
};

TEST_F(Run, ReturnsWhatItWrites) {
  testing::internal::CaptureStdout();
  const RunResult result = run(request("a"));
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "") << "a library says nothing unless it is asked to";
  EXPECT_EQ(result.folder, folder.path() / "a");
  EXPECT_TRUE(result.record.finished);
  EXPECT_EQ(result.record.particles, 64u);
  EXPECT_EQ(result.record.steps, 3);
  const auto json = nlohmann::json::parse(read_text(result.folder / "run.json"));
  EXPECT_EQ(json["steps"], 3);
  EXPECT_EQ(json["scheme"], result.record.scheme);
  EXPECT_EQ(json["wall_seconds"], result.record.wall_seconds);
  EXPECT_THROW(run(request("a")), InputError) << "the folder holds a run";
}

TEST_F(Run, GoesOnWhereItWasStopped) {
  run(request("whole"));
  RunRequest stopped = request("stopped");
  stopped.walltime = 1e-9;
  const RunResult first = run(stopped);
  EXPECT_FALSE(first.record.finished);
  EXPECT_LT(first.record.steps, 3);
  RunResult last = first;
  while (!last.record.finished) last = run({.resume = first.folder});
  EXPECT_EQ(last.record.steps, 3);
  EXPECT_EQ(read_text(folder.path() / "whole/history.csv"), read_text(first.folder / "history.csv"));
  EXPECT_THROW(run({.resume = folder.path() / "nowhere"}), InputError);
}

TEST_F(Run, ToldBeforeItRunsWritesNothing) {
  const DryRun told = dry_run(problem_of(request("a")));
  EXPECT_EQ(told.particles, 64u);
  EXPECT_EQ(told.steps, 3);
  EXPECT_GT(told.seconds_per_step, 0);
  EXPECT_EQ(told.seconds(), 3 * told.seconds_per_step);
  EXPECT_NE(told.text().find("particles   64 in 3D"), std::string::npos) << told.text();
  EXPECT_NE(told.text().find(bytes_text(told.peak_bytes) + " at its peak"), std::string::npos) << told.text();
  EXPECT_EQ(nlohmann::json::parse(told.json())["dry_run"]["particles"], 64);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST_F(Run, LeavesSnapshotsThatHaveRates) {
  const RunResult result = run(request("a"));
  const auto out = folder.path() / "rates.hdf5";
  const RatesResult found = rates({.file = (result.folder / "snap_0000.hdf5").string(), .overrides = {}, .out = out});
  EXPECT_EQ(found.particles, 64u);
  EXPECT_GT(found.fields, 5u);
  EXPECT_EQ(hdf5::File::open(out).group("PartType0").dataset("Acceleration").read<double>().size(), 3 * 64u);
}

}  // namespace
}  // namespace sphk
