// SPDX-License-Identifier: BSD-3-Clause

// What the numbers of a run mean goes with them, from what the user says or a file says into all that the run leaves.
#include "src/io/layouts.hpp"
#include "tests/cli/sphk_executable.hpp"

namespace sphk {
namespace {

constexpr int stopped = 75;
const std::string lattice = "run uniform -n 8 --set scene.lattice=cubic ";
const std::string galactic = "--set units.length=kpc --set units.mass='1e10 Msun' --set units.velocity=km/s ";
const std::string in_words = "all numbers are in kpc, 1e10 Msun, km/s and 977.79 Myr";
constexpr double kpc = 3.0856775814913673e21;
const Units galactic_units{kpc, 1e10 * 1.98841e33, kpc / 1e5};

class UnitsOfRuns : public Executable {
 protected:
  std::optional<Units> units(const std::string& name) const { return facts_of(hdf5::File::open(file(name))).units; }
};

TEST_F(UnitsOfRuns, GoIntoSnapshotsCheckpointsAndTheTable) {
  expect(lattice + galactic + "--steps 3 --walltime 0.001 --out run", stopped, {"note: " + in_words});
  EXPECT_EQ(units("run/checkpoint_a.hdf5"), galactic_units);
  expect("info run/checkpoint_a.hdf5", 0, {"units       kpc, 1e10 Msun, km/s and 977.79 Myr (3.08568e+21 cm"});
  expect("run --resume run", 0, {"complete", in_words});
  expect("info run", 0, {in_words});
  for (const char* name : {"run/snap_0000.hdf5", "run/snap_0001.hdf5"}) EXPECT_EQ(units(name), galactic_units) << name;
}

TEST_F(UnitsOfRuns, GoFromFileToFile) {
  expect(lattice + galactic + "--steps 1 --out run", 0, {"complete"});
  const std::string file = "run/snap_0001.hdf5 ";
  expect("run " + file + "--t-end 0.5 --steps 1 --out on", 0, {in_words});
  EXPECT_EQ(units("on/snap_0001.hdf5"), galactic_units);
  expect("rates " + file + "--out rates.hdf5", 0, {in_words});
  EXPECT_EQ(units("rates.hdf5"), galactic_units);
  expect("run " + file + "--t-end 0.5 --steps 1 --set units.length=pc --out other", 0,
         {"the file says that its units are kpc, 1e10 Msun", "taken for pc", "not converted"});
  EXPECT_EQ(units("other/snap_0001.hdf5"), (Units{3.0856775814913673e18, 1e10 * 1.98841e33, kpc / 1e5}));
}

TEST_F(UnitsOfRuns, AreThoseOfTheCodeWhereNobodySaysMore) {
  const Result run = sphk(lattice + "--steps 1 --out run");
  EXPECT_EQ(run.text.find("all numbers are in"), std::string::npos) << run.text;
  EXPECT_EQ(units("run/snap_0001.hdf5"), std::nullopt);
  expect("info run/snap_0001.hdf5", 0, {"units       code units"});
}

}  // namespace
}  // namespace sphk
