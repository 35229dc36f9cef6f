// SPDX-License-Identifier: BSD-3-Clause

// A run's folder belongs to one process, holds all that its run needs, and loses nothing that another run comes from.
#include <fmt/format.h>
#include <hdf5.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "src/io/checkpoint.hpp"
#include "src/report/process.hpp"
#include "tests/cli/sphk_executable.hpp"

namespace sphk {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int bad_input = 2, stopped = 75;
const std::string gas = "run uniform -n 8 --set scene.lattice=cubic --set scene.jitter=0.1 ";

std::string host() {
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  return name.data();
}

class RunFolders : public Executable {
 protected:
  /// A run without end in the folder D, once it has written its first snapshot.
  std::unique_ptr<Process> start_long_run() const {
    auto run = std::make_unique<Process>(
        std::vector<std::string>{SPHK_EXECUTABLE, "run", "uniform", "-n", "8", "--set", "scene.lattice=cubic",
                                 "--t-end", "1e6", "--out", file("D").string()},
        Process::Streams{.output = file("log")});
    while (!run->exit_code() && !fs::exists(file("D/snap_0000.hdf5")))
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_FALSE(run->exit_code()) << read_text(file("log"));
    return run;
  }
  Json lock() const { return Json::parse(read_text(file("D/run.lock"))); }
  void write_lock(const Json& changes) const {
    Json lock = {{"host", host()},
                 {"process", getpid()},
                 {"start", start_of_process(getpid())},
                 {"boot", read_text("/proc/sys/kernel/random/boot_id").substr(0, 36)},
                 {"numbered", fs::read_symlink("/proc/self/ns/pid").string()}};
    lock.update(changes);
    std::ofstream(file("D/run.lock")) << lock.dump();
  }
  void expect_unlocked() const { EXPECT_FALSE(fs::exists(file("D/run.lock"))); }
};

TEST_F(RunFolders, BelongToOneProcessWhichIsNamed) {
  const auto run = start_long_run();
  const std::string process = fmt::format("process {} on {}", lock()["process"].get<long>(), host());
  expect(gas + "--out D", bad_input, {"D belongs to the run of " + process, "--out"});
  expect(gas + "--out D --overwrite", bad_input, {process});
  expect("run --resume D", bad_input, {process});
  EXPECT_TRUE(fs::exists(file("D/snap_0000.hdf5")));
  run->ask_to_stop();
  EXPECT_EQ(run->wait(), stopped) << read_text(file("log"));
  expect_unlocked();
}

TEST_F(RunFolders, OfAKilledProcessAreTakenOver) {
  {
    const auto run = start_long_run();
    kill(lock()["process"].get<pid_t>(), SIGKILL);
    EXPECT_EQ(run->wait(), Process::by_signal + SIGKILL);
  }
  ASSERT_TRUE(fs::exists(file("D/run.lock")));
  for (const char* left : {".checkpoint_a.hdf5.1234.tmp", ".run.json.7.tmp", ".run.lock.99.tmp"})
    std::ofstream(file("D") / left) << "half";
  for (const char* other : {".notes.1234.tmp", ".checkpoint_a.hdf5.x.tmp"}) std::ofstream(file("D") / other) << "mine";
  expect(gas + "--steps 1 --out D --overwrite", 0, {"complete"});
  expect_unlocked();
  std::vector<std::string> hidden;
  for (const auto& entry : fs::directory_iterator(file("D")))
    if (const std::string name = entry.path().filename(); name.starts_with(".")) hidden.push_back(name);
  std::ranges::sort(hidden);
  EXPECT_EQ(hidden, (std::vector<std::string>{".checkpoint_a.hdf5.x.tmp", ".notes.1234.tmp"}));
}

TEST_F(RunFolders, AreTakenFromTheDeadAlone) {
  fs::create_directories(file("D"));
  const std::string run = gas + "--steps 1 --overwrite --out D";
  write_lock(Json::object());  // of this test, which lives
  expect(run, bad_input, {fmt::format("process {} on {}", getpid(), host())});
  write_lock({{"host", "elsewhere"}, {"process", 1}});
  expect(run, bad_input, {"process 1 on elsewhere", "remove"});
  write_lock({{"numbered", "pid:[0]"}, {"start", "1"}});  // in a container, where it may be alive
  expect(run, bad_input, {host()});
  std::ofstream(file("D/run.lock")) << "a note\n";
  expect(run, bad_input, {"no lock of sphk", "remove it"});
  write_lock({{"start", "1"}});  // the number is used again
  expect(run, 0, {"complete"});
  write_lock({{"boot", "before"}});
  expect(run, 0, {"complete"});
  expect_unlocked();
}

TEST_F(RunFolders, AreGivenBackByARunThatFails) {
  expect("run tube -n 50 --set sph.energy=energy --set time.courant=10 --out D", 3, {"last snapshot"});
  expect_unlocked();
}

TEST_F(RunFolders, KeepTheInitialConditionThatARunComesFrom) {
  expect(gas + "--steps 1 --out D", 0, {"complete"});
  fs::create_directory_symlink(file("D"), file("linked"));
  fs::create_symlink(file("D/snap_0001.hdf5"), file("link.hdf5"));
  for (const std::string from : {"D/snap_0001.hdf5", "linked/snap_0001.hdf5", "link.hdf5"})
    for (const std::string out : {"D", "linked"})
      expect("run " + from + " --t-end 0.5 --overwrite --out " + out, bad_input, {"would remove", "--out"});
  std::ofstream(file("my.toml")) << "scene = \"D/snap_0001.hdf5\"\ntime.end = 0.5\n";
  expect("run my.toml --overwrite --out D", bad_input, {"would remove"});
  expect("rates D/snap_0001.hdf5 --out linked/snap_0001.hdf5", bad_input, {"would replace", "--out"});
  expect("run D/snap_0001.hdf5 --t-end 0.5 --steps 1 --overwrite --out other", 0, {"complete"});
  EXPECT_TRUE(fs::exists(file("D/run.json")));
}

class LostFiles : public RunFolders {
 protected:
  /// A run of a file, and the same one stopped after its first steps.
  void SetUp() override {
    expect(gas + "--steps 1 --out gas", 0, {"complete"});
    fs::copy_file(file("gas/snap_0001.hdf5"), file("ic.hdf5"));
    const std::string run = "run ic.hdf5 --t-end 0.12 --set output.snapshots=2 --out ";
    expect(run + "whole", 0, {"complete"});
    expect(run + "D --walltime 0.001", stopped, {"--resume"});
  }
  void expect_same_end() const {
    expect("run --resume D", 0, {"complete"});
    EXPECT_EQ(read_text(file("D/history.csv")), read_text(file("whole/history.csv")));
    const std::string text = read_text(file("D/scene.used.toml"));
    EXPECT_EQ(text, read_text(file("whole/scene.used.toml")));
  }
  void cut(const std::string& name, int part) const {
    fs::resize_file(file(name), fs::file_size(file(name)) / static_cast<std::uintmax_t>(part));
  }
};

TEST_F(LostFiles, AreAllInTheCheckpoint) {
  fs::rename(file("ic.hdf5"), file("moved.hdf5"));
  fs::remove(file("D/scene.used.toml"));
  fs::remove(file("D/history.csv"));
  expect_same_end();
}

TEST_F(LostFiles, AndThoseCutShortAreWrittenAnew) {
  cut("D/scene.used.toml", 2);
  cut("D/history.csv", 2);
  expect_same_end();
}

TEST_F(LostFiles, ACheckpointOfAnotherLayoutIsRefusedWithTheWayOut) {
  const hid_t saved = H5Fopen(file("D/checkpoint_a.hdf5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t group = H5Gopen2(saved, "sphk/Checkpoint", H5P_DEFAULT);
  const hid_t layout = H5Aopen(group, "Layout", H5P_DEFAULT);
  const int other = checkpoint_layout + 8;
  EXPECT_GE(H5Awrite(layout, H5T_NATIVE_INT, &other), 0);
  H5Aclose(layout), H5Gclose(group), H5Fclose(saved);
  expect("run --resume D", bad_input,
         {fmt::format("layout is version {}", other), fmt::format("reads version {}", checkpoint_layout),
          "start a new run from it"});
}

TEST_F(RunFolders, ASignalOfTheTerminalOrTheLimitOfCpuTimeLeavesACheckpoint) {
  for (const int signal : {SIGHUP, SIGXCPU}) {
    const auto run = start_long_run();
    const auto process = lock()["process"].get<pid_t>();
    for (int twice = 0; twice < 2; ++twice) kill(process, signal);
    EXPECT_EQ(run->wait(), stopped) << signal << read_text(file("log"));
    EXPECT_TRUE(fs::exists(file("D/checkpoint_a.hdf5")));
    fs::remove_all(file("D"));
  }
}

TEST_F(RunFolders, ARunGoesOnWhenNobodyReadsWhatItPrints) {
  const std::string run = gas + "--t-end 0.05 --overwrite --out D";
  for (const std::string way : {" | head -c 1", " > /dev/full", " >&-"}) {
    sphk(run + way + " #");
    ASSERT_TRUE(fs::exists(file("D/run.json"))) << way;
    EXPECT_EQ(Json::parse(read_text(file("D/run.json")))["finished"], true) << way;
    EXPECT_TRUE(read_text(file("D/history.csv")).starts_with("step,time,")) << way;
    fs::remove_all(file("D"));
  }
}

TEST_F(RunFolders, TheWallClockTimeIsThatOfTheProcess) {
  for (const std::string time : {"1:2:3:4", "1:", ":1", "inf", "nan", "-1", "1h", ""})
    expect("run sod --walltime '" + time + "'", bad_input, {"--walltime"});
  for (const std::string time : {"0:00:00.001", "0:0.001", "0.001"})
    expect(gas + "--overwrite --out D --walltime " + time, stopped, {"after step 1"});
}

}  // namespace
}  // namespace sphk
