// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/run_loop.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "src/engine/errors.hpp"
#include "src/run/problem.hpp"
#include "src/run/stop_signal.hpp"
#include "src/schemes/registry.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

/// One particle that stays where it is; every step takes `dt` unless the end is nearer.
class Clock : public Simulation {
 public:
  explicit Clock(double dt) : dt_(dt) {}
  StepReport step(double t_end) override {
    last_.dt = std::min(dt_, t_end - last_.time);
    last_.time = last_.time + dt_ >= t_end ? t_end : last_.time + dt_;
    ++last_.step;
    ends.push_back(t_end);
    if (last_.step == fails_at) throw NumericsError("the clock broke");
    if (last_.step == stops_at) std::raise(SIGTERM);
    return last_;
  }
  void heat(const Array3&, double energy) override { heated += energy, heat_times.push_back(last_.time); }
  void add(const Gains&) override {}
  double time() const override { return last_.time; }
  std::size_t size() const override { return 1; }
  Totals totals() const override {
    return {.mass = 1, .thermal = 1 + gains * last_.time, .momentum = {}, .angular_momentum = {}};
  }
  Costs costs() const override { return {.updates = last_.step, .phases = {}}; }
  StepReport last_step() const override { return last_; }
  Snapshot view() const override {
    Snapshot s;
    s.time = last_.time;
    s.step = last_.step;
    s.id = {1};
    for (const char* name : {"Masses", "Densities", "InternalEnergies", "Pressures", "SmoothingLength", "Entropies"})
      s.fields.push_back({.name = name, .description = "", .units = {}, .components = 1, .values = {1}});
    for (const char* name : {"Coordinates", "Velocities"})
      s.fields.push_back({.name = name, .description = "", .units = {}, .components = 3, .values = {0.5, 0.5, 0.5}});
    return s;
  }
  HeldParticles held() const override { return {.id = {1}, .fields = {}, .memory = {}}; }
  std::vector<Field> rates(bool) override { return {}; }
  std::vector<Field> errors() const override { return {}; }
  void save(const TakeBlock& take) const override {
    const auto step = static_cast<std::uint8_t>(last_.step);
    take("clock", {&step, 1});
  }
  void restore(const GiveBlock&) override {}
  Counts counts() const override { return {}; }

  std::vector<double> ends, heat_times;  ///< the t_end of every step, the times of heatings
  double heated = 0;
  long fails_at = 0, stops_at = 0;
  double gains = 0;  ///< energy a time

 private:
  double dt_;
  StepReport last_;
};

class Still : public Scene {
 public:
  std::string name() const override { return "still"; }
  std::string summary() const override { return ""; }
  void declare(Settings&) const override {}
  ParticleSet build(const Settings&) const override { return {}; }
  std::map<std::string, ErrorNorm> errors(const Settings&, const Snapshot& s) const override {
    return {{"v", {.l1 = 10 * s.time, .where = {}}}};
  }
};

class RunLoopTest : public testing::Test {
 protected:
  RunLoopTest() {
    declare_engine_keys(settings);
    declare_run_keys(settings);
  }
  RunLoop::End run(Clock& clock, RunLoop::Plan plan) {
    RunOutput output(folder.path(), scene, settings);
    Progress progress(ProgressStyle::lines, {}, log);
    Checkpoints checkpoints(folder.path());
    RunLoop loop(clock, output, checkpoints, progress, plan, {});
    const auto end = loop.run();
    steps = loop.state().steps;
    return end;
  }
  /// Times of the outputs, as history.csv has them.
  std::vector<double> times() const {
    std::stringstream text(read_text(folder.path() / "history.csv"));
    std::vector<double> found;
    std::string line;
    std::getline(text, line);
    while (std::getline(text, line)) found.push_back(std::stod(line.substr(line.find(',') + 1)));
    return found;
  }

  TemporaryFolder folder;
  Still scene;
  Settings settings;
  std::FILE* log = std::fopen("/dev/null", "w");
  long steps = 0;
};

TEST_F(RunLoopTest, OutputsLieAtEqualIntervalsOfTimeAndNoStepPassesThem) {
  Clock clock(0.07);
  EXPECT_EQ(run(clock, {.end = 1, .steps = 0, .snapshots = 4}), RunLoop::End::finished);
  EXPECT_EQ(times(), (std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
  EXPECT_EQ(steps, 16);  // four to each quarter: 0.07, 0.14, 0.21, 0.25
  for (int k = 0; k <= 4; ++k)
    EXPECT_TRUE(std::filesystem::exists(folder.path() / ("snap_000" + std::to_string(k) + ".hdf5")));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "snap_0005.hdf5"));
}

TEST_F(RunLoopTest, FurtherRowsOfTheHistoryComeWithoutSnapshots) {
  Clock clock(0.07);
  run(clock, {.end = 1, .steps = 0, .snapshots = 2, .rows = {0.1, 0.4, 0.5, 0.51, 1}});
  EXPECT_EQ(times(), (std::vector<double>{0, 0.1, 0.4, 0.5, 0.51, 1}));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "snap_0002.hdf5"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "snap_0003.hdf5"));
}

TEST_F(RunLoopTest, HeatComesAtItsTimeAndOnce) {
  Clock clock(0.07);
  run(clock,
      {.end = 1, .steps = 0, .snapshots = 2, .rows = {0.1}, .heatings = {{0, {}, 1}, {0.3, {}, 2}, {0.5, {}, 4}}});
  EXPECT_EQ(clock.heat_times, (std::vector<double>{0, 0.3, 0.5}));
  EXPECT_EQ(clock.heated, 7);
  EXPECT_EQ(times(), (std::vector<double>{0, 0.1, 0.5, 1})) << "heat makes no row of its own";
}

TEST_F(RunLoopTest, ParaviewsSeriesNamesEverySnapshot) {
  Clock clock(1);
  run(clock, {.end = 1, .steps = 0, .snapshots = 2});
  const auto series = nlohmann::json::parse(read_text(folder.path() / "run.hdf.series"));
  ASSERT_EQ(series["files"].size(), 3u);
  EXPECT_EQ(series["files"][1]["name"], "snap_0001.hdf5");
  EXPECT_EQ(series["files"][1]["time"], 0.5);
}

TEST_F(RunLoopTest, TheLimitOfStepsEndsTheRunWithAnOutput) {
  Clock clock(0.1);
  EXPECT_EQ(run(clock, {.end = 1, .steps = 3, .snapshots = 1}), RunLoop::End::finished);
  EXPECT_EQ(steps, 3);
  ASSERT_EQ(times().size(), 2u);
  EXPECT_NEAR(times().back(), 0.3, 1e-15);
}

TEST_F(RunLoopTest, ErrorsGoIntoTheHistory) {
  Clock clock(1);
  run(clock, {.end = 1, .steps = 0, .snapshots = 2});
  std::stringstream text(read_text(folder.path() / "history.csv"));
  std::string names, first, second;
  std::getline(text, names), std::getline(text, first), std::getline(text, second);
  EXPECT_TRUE(names.ends_with(",l1_v")) << names;
  EXPECT_TRUE(second.ends_with(",5")) << second;  // 10 t at t = 0.5
}

TEST_F(RunLoopTest, ARunThatGainsTooMuchEnergyFailsAtAnOutput) {
  Clock clock(0.1);
  clock.gains = 1.5;
  try {
    run(clock, {.end = 1, .steps = 0, .snapshots = 4});
    FAIL();
  } catch (const NumericsError& error) {
    EXPECT_NE(std::string(error.what()).find("t = 0.75: the energy has drifted by 1.12"), std::string::npos)
        << error.what();
  }
  EXPECT_EQ(times().back(), 0.75) << "it is written what it came to";
}

TEST_F(RunLoopTest, HowMuchEnergyARunMayGainIsForTheUserToSay) {
  Clock clock(0.1);
  clock.gains = 1.5;
  EXPECT_EQ(run(clock, {.end = 1, .steps = 0, .snapshots = 4, .max_drift = 2}), RunLoop::End::finished);
}

TEST_F(RunLoopTest, ANumericsErrorPassesThrough) {
  Clock clock(0.1);
  clock.fails_at = 2;
  EXPECT_THROW(run(clock, {.end = 1, .steps = 0, .snapshots = 1}), NumericsError);
}

TEST_F(RunLoopTest, AFileNamedStopEndsItWithACheckpoint) {
  Clock clock(0.1);
  std::ofstream(folder.path() / "stop");
  EXPECT_EQ(run(clock, {.end = 1, .steps = 0, .snapshots = 1}), RunLoop::End::stopped);
  EXPECT_EQ(steps, 1);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "stop")) << "else it would end the next run too";
  const SavedRun saved = newest_checkpoint(folder.path(), scene, settings);
  EXPECT_EQ(saved.loop.steps, 1);
  EXPECT_EQ(saved.simulation("clock"), std::vector<std::uint8_t>{1});
  EXPECT_EQ(saved.output.snapshot_times, std::vector<double>{0});
}

TEST_F(RunLoopTest, WallClockTimeEndsItWithACheckpoint) {
  Clock clock(1e-9);
  EXPECT_EQ(run(clock, {.end = 1, .steps = 0, .snapshots = 1, .walltime = 0.05}), RunLoop::End::stopped);
  EXPECT_GT(steps, 0);
  EXPECT_EQ(newest_checkpoint(folder.path(), scene, settings).loop.steps, steps);
}

TEST_F(RunLoopTest, TheNewestWholeCheckpointIsTaken) {
  Clock clock(0.1);
  run(clock, {.end = 1, .steps = 6, .snapshots = 1, .checkpoint = 1e-9});  // after every step, by turns
  const SavedRun newest = newest_checkpoint(folder.path(), scene, settings);
  EXPECT_EQ(newest.loop.steps, 6);
  EXPECT_TRUE(newest.remarks.empty());
  // A bit of its state turns over, as on a bad disk.
  std::string bytes = read_text(newest.file);
  const auto at = bytes.find("\"steps\":6");
  ASSERT_NE(at, std::string::npos);
  bytes[at + 9] = '8';
  std::ofstream(newest.file, std::ios::binary) << bytes;
  const SavedRun other = newest_checkpoint(folder.path(), scene, settings);
  EXPECT_EQ(other.loop.steps, 5);
  ASSERT_EQ(other.remarks.size(), 1u);
  EXPECT_NE(other.remarks[0].find("is damaged"), std::string::npos) << other.remarks[0];
  std::ofstream(other.file, std::ios::binary) << "";
  EXPECT_THROW(newest_checkpoint(folder.path(), scene, settings), InputError);
}

TEST_F(RunLoopTest, ACheckpointOfAnotherRunIsNotTaken) {
  Clock clock(0.1);
  run(clock, {.end = 1, .steps = 2, .snapshots = 1, .checkpoint = 1e-9});
  settings.set("sph.neighbours", 50.0, Origin::file);
  try {
    newest_checkpoint(folder.path(), scene, settings);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("sph.neighbours is \"48.0\", not \"50.0\""), std::string::npos)
        << error.what();
  }
}

TEST_F(RunLoopTest, ASignalFinishesTheStepAndLeavesACheckpoint) {
  catch_stop_signals();
  Clock clock(0.1);
  clock.stops_at = 4;
  EXPECT_EQ(run(clock, {.end = 1, .steps = 0, .snapshots = 1}), RunLoop::End::stopped);
  EXPECT_EQ(steps, 4);
  EXPECT_EQ(times().size(), 1u) << "no output that a run without a stop would not have";
  EXPECT_EQ(newest_checkpoint(folder.path(), scene, settings).loop.steps, 4);
  catch_stop_signals();
  EXPECT_FALSE(stop_requested()) << "else no further run of this process would begin";
}

TEST(StopSignal, AStopSentTwiceAtOnceIsOneStop) {
  catch_stop_signals();
  for (const int signal : {SIGTERM, SIGTERM, SIGINT, SIGUSR1}) std::raise(signal);
  EXPECT_TRUE(stop_requested());
  catch_stop_signals();
}

TEST(StopSignal, ALaterOneEndsTheProgram) {
  const auto twice = [] {
    catch_stop_signals();
    std::raise(SIGINT);
    std::this_thread::sleep_for(std::chrono::seconds(2));
    std::raise(SIGTERM);
  };
  EXPECT_EXIT(twice(), testing::KilledBySignal(SIGTERM), "");
}

}  // namespace
}  // namespace sphk
