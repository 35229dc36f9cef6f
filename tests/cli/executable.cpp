// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>

#include "tests/cli/sphk_executable.hpp"

namespace sphk {
namespace {

constexpr const char* small_run = "run uniform -n 8 --set scene.lattice=cubic --set scene.jitter=0.1 --steps 3";

/// A blast wave with 25 times the stable time-step: within some steps a particle has lost more energy than it had.
constexpr const char* blow_up = "run tube -n 50 --set sph.energy=energy --set time.courant=10";

TEST_F(Executable, BadInputEndsWithCode2AndTellsHowToMendIt) {
  const std::pair<const char*, const char*> wrong[] = {
      {"run sodd", "sod"},
      {"run sod --set sph.kernal=cs", "did you mean \"sph.kernel\"?"},
      {"run sod --kernal cs", "--kernal: did you mean --kernel?"},
      {"run sod --set kernel", "write KEY=VALUE"},
      {"run missing.hdf5", "missing.hdf5"},
      {"run missing.toml", "missing.toml"},
      {"rum sod", "rum: did you mean run?"},
      {"", "--help"},
      {"info missing.hdf5", "missing.hdf5"},
      {"plot missing", "missing"},
      {"stability --kernel css --neighbours 32", "no smoothing kernel \"css\""},
      {"stability --kernel cs", "--neighbours"},
      {"stability --kernel cs --neighbours 32 --lattice cubical", "cubic, bcc"},
      {"run uniform -n 8 --set scene.lattice=cubic --t-end 0", "--t-end"},
  };
  for (const auto& [arguments, hint] : wrong) {
    const Result result = sphk(arguments);
    EXPECT_EQ(result.code, 2) << arguments << "\n" << result.text;
    EXPECT_NE(result.text.find(hint), std::string::npos) << arguments << "\n" << result.text;
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));  // nothing is left behind
}

/// CS with 42 neighbours does not hold a cubic lattice, HOCT4 with 96 does (R10 Table 1).
TEST_F(Executable, ARunTellsOfAnUnstableKernelAndNeighbourNumber) {
  const std::string run = "run uniform -n 10 --set scene.lattice=cubic --steps 1 --kernel ";
  EXPECT_NE(sphk(run + "cs --neighbours 42 --out a").text.find("sphk stability --kernel cs"), std::string::npos);
  EXPECT_EQ(sphk(run + "hoct4 --neighbours 96 --out b").text.find("sphk stability"), std::string::npos);
}

TEST_F(Executable, AFileThatIsNoHdf5IsBadInput) {
  std::ofstream(file("bad.hdf5")) << "this is text";
  for (const char* arguments :
       {"run bad.hdf5 --t-end 1", "info bad.hdf5", "ic check bad.hdf5", "rates bad.hdf5 --out r.hdf5"})
    EXPECT_EQ(sphk(arguments).code, 2) << arguments;
}

TEST_F(Executable, HelpHasExamplesForEveryCommand) {
  EXPECT_NE(sphk("--help").text.find("sphk run sod"), std::string::npos);
  for (const char* command : {"run", "plot", "rates", "show"}) {
    const Result result = sphk(std::string(command) + " --help");
    EXPECT_EQ(result.code, 0);
    EXPECT_NE(result.text.find("Example"), std::string::npos) << command;
  }
  EXPECT_EQ(sphk("--version").code, 0);
}

TEST_F(Executable, ARunLeavesTheFilesOfTheContract) {
  const Result result = sphk(small_run);
  ASSERT_EQ(result.code, 0) << result.text;
  for (const char* name :
       {"scene.used.toml", "snap_0000.hdf5", "snap_0001.hdf5", "run.hdf.series", "history.csv", "run.json"})
    EXPECT_TRUE(std::filesystem::exists(file("uniform-run") / name)) << name;
  const auto json = nlohmann::json::parse(read_text(file("uniform-run") / "run.json"));
  EXPECT_EQ(json["particles"], 512);  // 8^3
  EXPECT_EQ(json["steps"], 3);
  EXPECT_EQ(json["updates"], 3 * 512);
  EXPECT_EQ(json["finished"], true);
  EXPECT_GT(json["pair_interactions"], 0.0);
  EXPECT_GT(json["wall_seconds"], 0.0);
  EXPECT_LT(json["conservation"]["energy"], 1e-3);
  // The first line says what runs; without a terminal there is no bar.
  EXPECT_TRUE(result.text.starts_with("sphk ")) << result.text;
  for (const char* part :
       {"512 particles in 3D", "precision", " 1 thread,", "kernel cs", "updates/s", "phase", "sphk plot uniform-run"})
    EXPECT_NE(result.text.find(part), std::string::npos) << part << "\n" << result.text;
  EXPECT_EQ(result.text.find('\r'), std::string::npos);
}

TEST_F(Executable, AnotherRunTakesAnotherFolderAndOutIsNeverOverwrittenSilently) {
  const std::string quick = "run uniform -n 4 --set scene.lattice=cubic --steps 1";
  ASSERT_EQ(sphk(quick).code, 0);
  ASSERT_EQ(sphk(quick).code, 0);
  EXPECT_TRUE(std::filesystem::exists(file("uniform-run-2/run.json")));
  EXPECT_EQ(sphk(quick + " --out uniform-run").code, 2);
  EXPECT_EQ(sphk(quick + " --out uniform-run --overwrite").code, 0);
}

TEST_F(Executable, TheUsedSceneFileAndASnapshotRunAgain) {
  ASSERT_EQ(sphk(small_run).code, 0);
  EXPECT_EQ(sphk("run uniform-run/scene.used.toml --out again").code, 0);
  EXPECT_EQ(read_text(file("uniform-run/history.csv")).substr(0, 200),
            read_text(file("again/history.csv")).substr(0, 200));
  const Result result = sphk("run uniform-run/snap_0001.hdf5 --t-end 0.2 --steps 1");
  EXPECT_EQ(result.code, 0) << result.text;
  EXPECT_TRUE(std::filesystem::exists(file("file-run/run.json")));
}

TEST_F(Executable, ADryRunWritesNothing) {
  const Result result = sphk("run uniform -n 8 --set scene.lattice=cubic --dry-run");
  EXPECT_EQ(result.code, 0) << result.text;
  for (const char* part : {"particles   512", "memory", "time-step", "steps", "output", "run time"})
    EXPECT_NE(result.text.find(part), std::string::npos) << part << "\n" << result.text;
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST_F(Executable, AJsonLogHoldsNothingButJson) {
  const Result result = sphk(std::string(small_run) + " --json-log");
  std::stringstream lines(result.text);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) EXPECT_TRUE(nlohmann::json::accept(line)) << line;
  EXPECT_GT(count, 2);
}

/// The last line of what was printed.
nlohmann::json last_object(const std::string& text) {
  const auto end = text.find_last_not_of('\n');
  const auto begin = text.rfind('\n', end);
  return nlohmann::json::parse(text.substr(begin == std::string::npos ? 0 : begin + 1));
}

TEST_F(Executable, AJsonLogTellsOfErrorsToo) {
  const std::pair<const char*, int> wrong[] = {{"run sodd", 2},
                                               {"run sod --set sph.kernal=cs", 2},
                                               {"run sod --kernal cs", 2},
                                               {"run sod --kernel wc3", 2},
                                               {blow_up, 3}};
  for (const auto& [arguments, code] : wrong) {
    const Result result = sphk(std::string(arguments) + " --json-log");
    EXPECT_EQ(result.code, code) << result.text;
    EXPECT_EQ(last_object(result.text)["exit_code"], code) << result.text;
    EXPECT_FALSE(last_object(result.text)["error"].get<std::string>().empty());
  }
}

TEST_F(Executable, AJsonLogEndsWithWhatTheRunCameTo) {
  const auto end = last_object(sphk(std::string(small_run) + " --json-log").text);
  EXPECT_EQ(end["finished"], true);
  EXPECT_EQ(end["folder"], "uniform-run");
  const auto told = last_object(sphk(std::string(small_run) + " --dry-run --json-log").text);
  EXPECT_EQ(told["dry_run"]["particles"], 512);
  EXPECT_EQ(told["dry_run"]["steps"], 3);
}

/// What is told of memory beforehand is what the run takes, for all particles tried and for more than are tried.
TEST_F(Executable, TellsTheMemoryOfARunBeforehand) {
  for (const std::string size :
       {"uniform -n 40", "uniform -n 500 --set scene.dimension=2 --kernel cs --neighbours 20"}) {
    const std::string command = "run " + size + " --set scene.lattice=cubic --scheme sph --steps 1";
    const auto told = last_object(sphk(command + " --dry-run --json-log").text)["dry_run"];
    ASSERT_EQ(sphk(command + " --overwrite --out run").code, 0);
    const auto json = nlohmann::json::parse(read_text(folder.path() / "run/run.json"));
    const double taken = json["peak_memory_bytes"], expected = told["peak_memory_bytes"];
    EXPECT_NEAR(expected, taken, 0.15 * taken) << size;
    EXPECT_EQ(told["particles"], json["particles"]);
  }
}

TEST_F(Executable, RatesKeepTheOrderOfTheFile) {
  ASSERT_EQ(sphk(small_run).code, 0);
  const Result result =
      sphk("rates uniform-run/snap_0001.hdf5 --scheme gadget2 --neighbours 42 --out rates.hdf5 --split");
  EXPECT_EQ(result.code, 0) << result.text;
  const Result info = sphk("info rates.hdf5");
  EXPECT_EQ(info.code, 0) << info.text;
  EXPECT_NE(info.text.find("Acceleration"), std::string::npos) << info.text;
}

TEST_F(Executable, ListShowInfoAndCheckWork) {
  const Result list = sphk("list");
  EXPECT_EQ(list.code, 0);
  for (const char* scene : {"sod", "gresho", "sedov", "noh", "uniform"})
    EXPECT_NE(list.text.find(std::string("\n") + scene), std::string::npos) << list.text;
  const Result show = sphk("show gresho -n 16 --kernel hoct4");
  EXPECT_EQ(show.code, 0);
  for (const char* part : {"passes", "terms", "fields", "bytes per particle", "sph.neighbours", "hoct4"})
    EXPECT_NE(show.text.find(part), std::string::npos) << part << "\n" << show.text;
  ASSERT_EQ(sphk(small_run).code, 0);
  EXPECT_EQ(sphk("info uniform-run/snap_0000.hdf5").code, 0);
  EXPECT_EQ(sphk("ic check uniform-run/snap_0000.hdf5").code, 0);
}

TEST_F(Executable, NumbersThatGoWrongEndWithCode3AndKeepTheRun) {
  const Result result = sphk(std::string(blow_up) + " --out bad");
  EXPECT_EQ(result.code, 3) << result.text;
  EXPECT_NE(result.text.find("its last snapshot is snap_"), std::string::npos) << result.text;
  EXPECT_EQ(nlohmann::json::parse(read_text(file("bad/run.json")))["finished"], false);
}

// SIGTERM in a long run: a checkpoint is written and the exit code says so. The test's `timeout` gets it, which sends
// it on to the program and to their process group.
TEST_F(Executable, ASignalStopsTheRunWithCode75) {
  const Result result = sphk(
      "run uniform -n 16 --set scene.lattice=cubic --t-end 1000 --out stopped & pid=$!; "
      "for k in $(seq 300); do [ -e stopped/snap_0000.hdf5 ] && break; sleep 0.1; done; sleep 0.5; kill -TERM $pid; "
      "wait $pid");
  EXPECT_EQ(result.code, 75) << result.text;
  EXPECT_TRUE(std::filesystem::exists(file("stopped/checkpoint_a.hdf5"))) << result.text;
  EXPECT_FALSE(std::filesystem::exists(file("stopped/snap_0001.hdf5"))) << "no output that a run without a stop lacks";
  EXPECT_EQ(nlohmann::json::parse(read_text(file("stopped/run.json")))["finished"], false);
}

}  // namespace
}  // namespace sphk
