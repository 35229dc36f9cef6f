// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/info.hpp"

#include <limits>

#include "tests/io/example.hpp"

namespace sphk {
namespace {

using Info = Scratch;

TEST_F(Info, TellsOfAnOwnSnapshot) {
  Snapshot s = example_snapshot(2, 4);
  s.fields[3].values = {1, 2, 6, std::numeric_limits<double>::infinity()};  // Densities: mean of the finite ones 3
  write_snapshot(file("snap.hdf5"), s, example_info());
  const std::string text = file_info(file("snap.hdf5"));
  EXPECT_TRUE(mentions(
      text, {"snap.hdf5: sphk snapshot", "0.33333333", "step        17", "dimension   2", "units       code units",
             "[0.2, 1.7) periodic x [0.1, 1.6) periodic", "sph, kernel cs, 48 neighbours", "1.4",
             "4 particles (PartType0)", "Density", "another name of", "Coordinates.x"}));
  EXPECT_TRUE(mentions(text, {"Densities" + std::string(32, ' ') + "1             3             6  (1 not finite)"}));
}

/// The example lies in [0.2, 1.7), so that the file's own coordinates begin at 0.
TEST_F(Info, CoordinatesAreThoseOfTheRun) {
  Snapshot s = example_snapshot(2, 2);
  s.fields[0].values = {0.25, 0.5, 0, 1.5, 0.75, 0};
  write_snapshot(file("snap.hdf5"), s, example_info());
  EXPECT_TRUE(mentions(file_info(file("snap.hdf5")),
                       {"Coordinates.x                         0.25         0.875           1.5",
                        "Coordinates.z                            0             0             0"}));
}

TEST_F(Info, UnitsAreNamedAndGivenInCgs) {
  SnapshotInfo info = example_info();
  info.units = Units{3.0857e21, 1.989e43, 3.0857e16};
  write_snapshot(file("snap.hdf5"), example_snapshot(3, 4), info);
  EXPECT_TRUE(mentions(file_info(file("snap.hdf5")),
                       {"units       kpc, 1e10 Msun, km/s and 977.8 Myr",  // 3.0857e16 / 3.15576e13
                        "(3.0857e+21 cm, 1.989e+43 g, 100000 cm/s, 3.0857e+16 s)"}));
}

TEST_F(Info, CountsOtherTypes) {
  auto made = hdf5::File::create();
  auto header = made.create_group("Header");
  header.set("BoxSize", 2.0);
  header.set("NumPart_ThisFile", std::vector<int>{0, 12, 0, 0, 3, 0, 5});
  made.save(file("ic.hdf5"));
  EXPECT_TRUE(
      mentions(file_info(file("ic.hdf5")), {"SWIFT and GADGET", "12 particles (PartType1)", "dark matter", "stars",
                                            "5 particles (PartType6)", "no run can start from it", "no gas"}));
}

TEST_F(Info, RemarksOfTheReaderAreShown) {
  ExampleIc{}.make().save(file("ic.hdf5"));
  EXPECT_TRUE(mentions(file_info(file("ic.hdf5")), {"note: the file does not say its units"}));
}

// No rows of so many columns are no bytes at all, so that the size of the file does not speak against them.
TEST_F(Info, AFieldOfEndlessColumnsIsOneLine) {
  auto made = ExampleIc{}.make();
  made.group("PartType0").write("Wide", std::vector<double>{}, hsize_t{1} << 40);
  made.save(file("wide.hdf5"));
  EXPECT_TRUE(mentions(file_info(file("wide.hdf5")), {"Wide", "1099511627776 columns"}));
}

}  // namespace
}  // namespace sphk
