// SPDX-License-Identifier: BSD-3-Clause

// Wrong input ends with a sentence and its exit code; what looks wrong and is not runs.
#include <fmt/format.h>
#include <sys/stat.h>

#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "src/report/history.hpp"
#include "src/scenes/block.hpp"
#include "tests/cli/gas_file.hpp"
#include "tests/cli/sphk_executable.hpp"

namespace sphk {
namespace {

constexpr int bad_input = 2, numerics = 3;
constexpr std::size_t row = 7;  // of the particle that is spoiled: id 8
constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();

using Words = std::vector<std::string>;
using Change = std::function<void(ParticleSet&)>;

/// Even gas at rest in a periodic box: density 1, and the pressure 1 of gamma = 5/3.
ParticleSet even_gas(int dimension) {
  ParticleSet gas;
  gas.dimension = dimension;
  gas.x = lattice_points({.dimension = dimension, .counts = even_counts(dimension, 6)});
  for (int axis = 0; axis < dimension; ++axis) gas.box.periodic[axis] = true;
  gas.v.assign(gas.size(), {});
  gas.m.assign(gas.size(), 1 / static_cast<double>(gas.size()));
  gas.u.assign(gas.size(), 1.5);
  gas.h.assign(gas.size(), 0.4);
  return gas;
}

class Guards : public Executable {
 protected:
  /// A file of even gas that is changed before it is written.
  void write_gas(
      const std::string& name, const Change& change = [](ParticleSet&) {}, int dimension = 3) const {
    ParticleSet gas = even_gas(dimension);
    change(gas);
    write_gas_file(file(name), gas);
  }
  /// Two steps of such gas.
  void expect_of_gas(const std::string& name, const Change& change, int code, const Words& words,
                     const std::string& more = "", int dimension = 3) const {
    write_gas(name, change, dimension);
    expect("run " + name + " --out run --overwrite --t-end 0.1 --steps 2 " + more, code, words);
  }
};

TEST_F(Guards, ValuesThatAreNoNumbersAreNamedWithFileDatasetAndRow) {
  const std::pair<const char*, double& (*)(ParticleSet&)> datasets[] = {
      {"Coordinates", [](ParticleSet& gas) -> double& { return gas.x[row][1]; }},
      {"Velocities", [](ParticleSet& gas) -> double& { return gas.v[row][2]; }},
      {"Masses", [](ParticleSet& gas) -> double& { return gas.m[row]; }},
      {"InternalEnergies", [](ParticleSet& gas) -> double& { return gas.u[row]; }},
      {"SmoothingLengths", [](ParticleSet& gas) -> double& { return gas.h[row]; }}};
  for (const auto& [dataset, value] : datasets)
    for (const double wrong : {nan, infinity, -infinity}) {
      const std::string name = fmt::format("{}{}.hdf5", dataset, wrong);
      expect_of_gas(name, [wrong, value = value](ParticleSet& gas) { value(gas) = wrong; }, bad_input,
                    {name, dataset, fmt::format("row {} (from 0) is {}", row, wrong), "mend the file"});
    }
}

TEST_F(Guards, KnownLimitsAreToldByEveryCommandThatMeetsThemAndByNoOther) {
  const Words commands{"run {} --t-end 0.1 --steps 1 --overwrite --out run", "rates {} --out rates.hdf5", "ic check {}",
                       "info {}"};
  write_gas("contact.hdf5", [](ParticleSet& gas) {
    for (std::size_t i = 0; i < gas.size(); ++i)
      if (gas.x[i][0] < 0.5) gas.m[i] *= 200, gas.u[i] /= 200;
  });
  write_gas("even.hdf5");
  for (const std::string& command : commands) {
    expect(fmt::format(fmt::runtime(command), "contact.hdf5"), 0, {"note: gas of densities 1:200", "osph-coherent"});
    EXPECT_EQ(sphk(fmt::format(fmt::runtime(command), "even.hdf5")).text.find("side by side"), std::string::npos);
  }
}

TEST_F(Guards, NegativeMassesEnergiesAndSupportsAreRefused) {
  const auto refused = [&](const std::string& name, const std::string& problem, const Change& change) {
    expect_of_gas(name, change, bad_input, {name, "mended", problem, "row 7 (id 8)"});
  };
  refused("m-negative.hdf5", "zero or negative mass", [](auto& gas) { gas.m[row] = -1; });
  refused("m-zero.hdf5", "zero or negative mass", [](auto& gas) { gas.m[row] = 0; });
  refused("u-negative.hdf5", "negative specific thermal energy", [](auto& gas) { gas.u[row] = -1; });
  refused("h-negative.hdf5", "negative smoothing length", [](auto& gas) { gas.h[row] = -1; });
}

TEST_F(Guards, SupportsOfZeroAreFoundAndEnergiesOfZeroRun) {
  const auto runs = [&](const std::string& name, const std::string& note, const Change& change) {
    expect_of_gas(name, change, 0, {note});
  };
  runs("h-zero.hdf5", "smoothing lengths of 0 (1 of 216) will be found", [](auto& gas) { gas.h[row] = 0; });
  runs("h-zeros.hdf5", "they will be found", [](auto& gas) { gas.h.assign(gas.size(), 0); });
  runs("u-zero.hdf5", "complete", [](auto& gas) { gas.u[row] = 0; });
  runs("u-zeros.hdf5", "complete", [](auto& gas) { gas.u.assign(gas.size(), 0); });
}

TEST_F(Guards, AnAdiabaticIndexOfOneOrLessIsRefused) {
  for (const std::string gamma : {"1", "0.9", "-1", "0", "nan", "inf"})
    expect("run sod --set sph.gamma=" + gamma, bad_input,
           {"--set sph.gamma=" + gamma, "must lie between 1.0000001 and 100"});
}

TEST_F(Guards, AnAdiabaticIndexNearOneAndOneOfFiveRunAndConserve) {
  for (const std::string gamma : {"1.0001", "5"}) {
    expect("run sod -n 64 --scheme gadget2 --set scene.dimension=1 --set sph.gamma=" + gamma + " --out " + gamma, 0,
           {"complete"});
    const auto drift = nlohmann::json::parse(read_text(file(gamma + "/run.json")))["conservation"];
    EXPECT_LT(drift["energy"], 1e-3) << gamma;
    EXPECT_LT(drift["momentum"], 1e-6) << gamma;
    for (const HistoryRow& now : read_history(file(gamma + "/history.csv"))) EXPECT_GT(now.at("min_A"), 0) << gamma;
  }
}

TEST_F(Guards, StepsThatDoNotChangeTheTimeNameTheParticleAndTheRemedy) {
  const auto stuck = [&](const std::string& name, const std::string& more, Words words, const Change& change) {
    words.insert(words.end(), {"step 0, t = ", "the particle with id "});
    const auto late = [&](ParticleSet& gas) { gas.time = 0.01, change(gas); };  // t = 0 grows with any step
    expect_of_gas(name, late, numerics, words, more);
  };
  const auto fast = [](double v) { return [=](ParticleSet& gas) { gas.v[row][0] = v; }; };
  const auto hot = [](ParticleSet& gas) { gas.u[row] = 1e36; };
  stuck("fast.hdf5", "--precision double", {"too short to change the time", "time.courant"}, fast(1e18));
  stuck("hot.hdf5", "", {"too short to change the time", "time.courant"}, hot);
  stuck("hot-own.hdf5", "--set time.steps=individual", {"below the shortest one", "output.snapshots"}, hot);
  stuck("faster.hdf5", "", {"too short to change the time", "time.courant"}, fast(1e20));
}

TEST_F(Guards, FewerParticlesThanNeighboursRunAndNoneDoNot) {
  const auto some = [](std::size_t n, bool periodic) {
    return [=](ParticleSet& gas) {
      for (auto* column : {&gas.m, &gas.u, &gas.h}) column->resize(n);
      for (auto* column : {&gas.x, &gas.v}) column->resize(n);
      gas.box.periodic.fill(periodic);
    };
  };
  const std::string images = "without periodic images";
  expect_of_gas("none.hdf5", some(0, true), bad_input, {"none.hdf5", "no gas particles", "at least one"});
  expect_of_gas("open.hdf5", some(10, false), 0, {"asked of 10 particles " + images, "sph.neighbours"});
  expect_of_gas("periodic.hdf5", some(10, true), 0, {"complete"});
  EXPECT_EQ(sphk("run periodic.hdf5 --t-end 0.1 --steps 2 --out again").text.find(images), std::string::npos);
}

TEST_F(Guards, AFlatGasThatIsSaidToBe3DRuns) {
  expect_of_gas(
      "sheet.hdf5", [](auto& gas) { gas.dimension = 3; }, 0, {"complete"}, "", 2);
}

TEST_F(Guards, AFlatGasWithoutADimensionIsAskedForIt) {
  const auto unsaid = [](auto& gas) { gas.dimension = 0; };  // no attribute is written
  expect_of_gas("plane.hdf5", unsaid, bad_input, {"the same z", "scene.dimension=2 or 3"}, "", 2);
  expect_of_gas("line.hdf5", unsaid, bad_input, {"the same y and z", "scene.dimension=1 or 3"}, "", 1);
  expect("ic check line.hdf5", bad_input, {"error: all particles have the same y and z", "No run can start"});
  expect("info line.hdf5", 0, {"no run can start from it: all particles have the same y and z"});
  expect("rates line.hdf5 --out rates.hdf5", bad_input, {"the same y and z"});
  expect("run plane.hdf5 --steps 2 --t-end 0.1 --out 2d --set scene.dimension=2", 0, {"in 2D", "complete"});
  expect("run plane.hdf5 --steps 2 --t-end 0.1 --out 3d --set scene.dimension=3", 0, {"in 3D", "complete"});
  expect("run plane.hdf5 --t-end 0.1 --out 1d --set scene.dimension=1", bad_input, {"row 1 ", "lies elsewhere"});
}

TEST_F(Guards, EveryCommandSaysWhatWasAssumedOfAFile) {
  write_gas("gas.hdf5", [](auto& gas) { gas.x[row][0] = 1.25; });
  for (const std::string command : {"run gas.hdf5 --t-end 0.1 --steps 1 --out run", "rates gas.hdf5 --out rates.hdf5",
                                    "info gas.hdf5", "ic check gas.hdf5"})
    expect(command, 0,
           {"note: the file does not say its adiabatic index", "note: the file does not say its units",
            "note: smoothing lengths are not used", "note: 1 particle outside the box: row 7 (id 8)"});
}

TEST_F(Guards, PipesAndFoldersAreRefused) {
  for (const char* name : {"pipe.hdf5", "pipe.toml"}) {
    mkfifo(file(name).c_str(), 0600);
    expect(std::string("run ") + name, bad_input, {name, "a pipe"});
  }
  expect("info pipe.hdf5", bad_input, {"a pipe"});
  for (const char* name : {"folder.hdf5", "folder.toml"}) {
    std::filesystem::create_directory(file(name));
    expect(std::string("run ") + name, bad_input, {name, "a folder"});
  }
}

TEST_F(Guards, FoldersThatCannotBeMadeAreNamedWithTheRemedy) {
  write_gas("gas.hdf5");
  std::ofstream(file("file")) << "in the way of a folder\n";
  for (const std::string place : {"file/run", "/proc/run"})
    expect("run gas.hdf5 --t-end 0.1 --steps 1 --out " + place, bad_input,
           {"cannot make the run's folder", place, "choose another place with --out"});
  expect("rates gas.hdf5 --out file/rates.hdf5", bad_input, {"file/rates.hdf5", "there is no folder", "mkdir"});
  expect("rates gas.hdf5 --out /proc/rates.hdf5", bad_input,
         {"/proc/rates.hdf5", "cannot be written", "choose another folder"});
}

TEST_F(Guards, FilesThatWereCutShortAreRefused) {
  write_gas("whole.hdf5");
  const auto size = std::filesystem::file_size(file("whole.hdf5"));
  for (const int quarters : {0, 1, 2, 3}) {
    const std::string name = fmt::format("cut-{}.hdf5", quarters);
    std::filesystem::copy_file(file("whole.hdf5"), file(name));
    std::filesystem::resize_file(file(name), quarters * size / 4);
    expect("run " + name + " --t-end 0.1 --out run", bad_input, {name, "no readable HDF5 file", "anew"});
  }
}

}  // namespace
}  // namespace sphk
