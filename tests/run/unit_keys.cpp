// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/unit_keys.hpp"

#include <gtest/gtest.h>

#include "src/engine/errors.hpp"
#include "src/io/hdf5_file.hpp"
#include "src/run/problem.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

constexpr double kpc = 3.0856775814913673e21;

class UnitKeys : public testing::Test {
 protected:
  std::string scene_file(const std::string& units) const {
    const std::string path = (folder.path() / "my.toml").string();
    std::ofstream(path) << "scene = \"sod\"\n" << units;
    return path;
  }
  std::optional<Units> units(const std::string& what, const std::vector<Override>& overrides = {}) const {
    return units_of(resolve_problem(what, overrides).settings);
  }
  std::string message(const std::string& what, const std::vector<Override>& overrides = {}) const {
    try {
      resolve_problem(what, overrides);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  /// Eight particles in units of 3 cm, 5 g and 7 s.
  std::string gas_file() const {
    const std::string path = (folder.path() / "gas.hdf5").string();
    hdf5::File made = hdf5::File::create();
    made.create_group("Header").set("BoxSize", std::vector<double>{2});
    hdf5::Group group = made.create_group("Units");
    group.set("Unit length in cgs (U_L)", 3.0);
    group.set("Unit mass in cgs (U_M)", 5.0);
    group.set("Unit time in cgs (U_t)", 7.0);
    hdf5::Group gas = made.create_group("PartType0");
    std::vector<double> x;
    for (int i = 0; i < 8; ++i) x.insert(x.end(), {0.5 + (i & 1), 0.5 + (i >> 1 & 1), 0.5 + (i >> 2)});
    gas.write("Coordinates", x, 3);
    gas.write("Velocities", std::vector<double>(24), 3);
    gas.write("Masses", std::vector<double>(8, 1.0));
    gas.write("InternalEnergies", std::vector<double>(8, 1.0));
    made.save(path);
    return path;
  }
  TemporaryFolder folder;
};

TEST_F(UnitKeys, NamesAndNumbersOfASceneFile) {
  EXPECT_EQ(units("sod"), std::nullopt);
  EXPECT_EQ(units(scene_file("[units]\nlength = \"kpc\"\nmass = 2e43\nvelocity = \"km/s\"\n")),
            (Units{kpc, 2e43, kpc / 1e5}));
  EXPECT_EQ(units(scene_file("units.length = 100\nunits.mass = \"kg\"\nunits.time = \"min\"\n")),
            (Units{100, 1000, 60}));
  EXPECT_EQ(units("sod", {{"units.length", "m", ""}, {"units.mass", "3", ""}, {"units.time", "2 h", ""}}),
            (Units{100, 3, 7200}));
}

TEST_F(UnitKeys, NonsenseIsRefusedWithItsPlace) {
  const auto mentions = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  };
  mentions(message(scene_file("[units]\nlength = \"kpcc\"\nmass = 0\n")),
           "my.toml:3:10: \"kpcc\" is no unit of length");
  mentions(message(scene_file("[units]\nlength = \"kpcc\"\nmass = 0\n")), "my.toml:4:8: \"0\" is no unit of mass");
  mentions(message(scene_file("[units]\nmass = nan\n")), "\"nan\" is no unit of mass");
  mentions(message(scene_file("[units]\nmass = true\n")), "a string is wanted");
  mentions(message("sod", {{"units.time", "-1 Gyr", "--set units.time=-1 Gyr"}}),
           "--set units.time=-1 Gyr: \"-1 Gyr\" is no unit of time");
  mentions(message(scene_file("units.length = \"kpc\"\n")), "units.mass is not given");
  mentions(message(scene_file("units.length = 1\nunits.mass = 1\n")), "units.time or units.velocity is not given");
  mentions(message(scene_file("units.length = 1\nunits.mass = 1\nunits.time = 1\nunits.velocity = 1\n")), "remove one");
}

TEST_F(UnitKeys, AFileSaysItsOwnUnlessOthersAreAskedFor) {
  EXPECT_EQ(units(gas_file()), (Units{3, 5, 7}));
  const Problem as_it_is = resolve_problem(gas_file(), {});
  EXPECT_EQ(input_remarks(as_it_is).back(), "all numbers are in 3 cm, 5 g, 0.42857 cm/s and 7 s");  // 3/7
  const Problem other = resolve_problem(gas_file(), {{"units.velocity", "km/s", ""}});
  EXPECT_EQ(units_of(other.settings), (Units{3, 5, 3 / 1e5}));
  EXPECT_NE(input_remarks(other).back().find("the file says that its units are 3 cm, 5 g, 0.42857 cm/s and 7 s"),
            std::string::npos);
  EXPECT_NE(input_remarks(other).back().find("not converted"), std::string::npos);
}

/// What scene.used.toml says is what the run had, whoever decided it.
TEST_F(UnitKeys, AreKeptByTheSceneFileThatARunLeaves) {
  for (const std::vector<Override>& overrides :
       {std::vector<Override>{}, {{"units.velocity", "km/s", ""}}, {{"units.length", "kpc", ""}}}) {
    const Problem problem = resolve_problem(gas_file(), overrides);
    const SceneFile used(folder.path() / "used.toml", used_scene_file(problem.settings, problem.scene->name()));
    EXPECT_EQ(units_of(resolve_run(used, {}).settings), units_of(problem.settings));
  }
}

}  // namespace
}  // namespace sphk
