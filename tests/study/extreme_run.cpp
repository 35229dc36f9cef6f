// SPDX-License-Identifier: BSD-3-Clause
#include "src/study/extreme_run.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/engine/errors.hpp"
#include "src/io/snapshot_writer.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

/// Gas of density 1 on the right of x = 0.5, of density 4 on its left.
class Jump final : public Scene {
 public:
  std::string name() const override { return "jump"; }
  std::string summary() const override { return ""; }
  void declare(Settings&) const override {}
  ParticleSet build(const Settings&) const override { return {}; }
  std::function<GasState(const Array3& x, double t)> exact(const Settings&) const override {
    return [](const Array3& x, double) { return GasState{.rho = x[0] < 0.5 ? 4.0 : 1.0}; };
  }
};

/// Ten particles along the unit box, 0.1 apart, with supports of 0.2, of which six are dense.
Snapshot gas() {
  Snapshot snapshot{.dimension = 1};
  const auto column = [&](const char* name, double value) {
    snapshot.fields.push_back({name, name, {}, 1, std::vector<double>(10, value)});
  };
  for (const char* name : {"Coordinates", "Velocities"})
    snapshot.fields.push_back({name, name, {}, 3, std::vector<double>(30, 0.0)});
  for (const char* name : {"Masses", "Densities", "InternalEnergies", "Pressures", "Entropies"}) column(name, 1);
  column("SmoothingLength", 0.2);
  for (std::size_t k = 0; k < 10; ++k) {
    snapshot.id.push_back(k + 1);
    snapshot.fields[0].values[3 * k] = 0.05 + 0.1 * static_cast<double>(k);
    snapshot.fields[3].values[k] = k < 6 ? 4 : 1;
  }
  return snapshot;
}

class ExtremeRun : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder.path() / "run.json") << R"({"updates": 50, "pair_interactions": 3000, "neighbours": 20})";
    write("time,energy_drift,min_rho,roundness\n0,0,1,0.5\n0.1,1e-4,1,0.75\n", gas());
  }
  void write(const std::string& history, const Snapshot& snapshot) {
    std::ofstream(folder.path() / "history.csv") << history;
    write_snapshot(folder.path() / "snap_0001.hdf5", snapshot, {});
  }
  Quantity quantity(const std::string& name) const { return quantity_of(name, {folder.path(), scene, settings}); }
  Jump scene;
  Settings settings;
  TemporaryFolder folder;
};

TEST_F(ExtremeRun, HasTheNumbersOfItsFiles) {
  EXPECT_EQ(quantity("energy").value, 1e-4) << "its drift";
  EXPECT_EQ(quantity("pairs").value, 3);  // 3000 / 50 updates / 20 neighbours
  EXPECT_EQ(quantity("roundness").value, 0.75) << "of the last row";
  for (const char* name : {"momentum", "rho", "roundnes"}) EXPECT_THROW(quantity(name), InputError) << name;
}

// The foremost dense particle is at 0.55, the jump at 0.5; the scan of the exact solution has steps of 1e-5.
TEST_F(ExtremeRun, HasItsFrontSoManySupportsFromTheExactOne) {
  EXPECT_NEAR(quantity("front").value, 0.05 / 0.2, 1e-4);
}

TEST_F(ExtremeRun, TellsWhichNumbersAreUnsound) {
  EXPECT_EQ(quantity("unsound").value, 0);
  Snapshot snapshot = gas();
  snapshot.fields[1].values[4] = std::nan("");
  snapshot.fields[4].values[7] = -1;
  write("time,min_rho,mach\n0,1,0\n0.25,0,-1\n", snapshot);
  EXPECT_EQ(quantity("unsound").value, 3) << "a velocity, an energy, and the density of the history";
  EXPECT_EQ(quantity("unsound").where, "Velocities nan at row 4");
}

TEST_F(ExtremeRun, DiffersFromAnotherByTheLargestDifferenceOfAColumn) {
  const auto one = folder.path() / "snap_0001.hdf5", other = folder.path() / "other.hdf5";
  Snapshot snapshot = gas();
  write_snapshot(other, snapshot, {});
  EXPECT_EQ(difference(one, other), 0);
  snapshot.fields[3].values[2] = 3.5;  // of a density of 4
  write_snapshot(other, snapshot, {});
  EXPECT_EQ(difference(one, other), 0.125);
  snapshot.fields[3].values[2] = std::nan("");
  write_snapshot(other, snapshot, {});
  EXPECT_EQ(difference(one, other), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace sphk
