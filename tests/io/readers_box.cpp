// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/readers_box.hpp"

#include "src/io/reader.hpp"
#include "tests/io/example.hpp"

namespace sphk {
namespace {

/// Two particles in an open plane around 0; supports of 1/4 and 1/8.
Snapshot open_plane() {
  Snapshot s = example_snapshot(2, 2);
  s.box = {{-2, -1, 0}, {4, 2, 1}, {false, false, false}};
  s.fields[0].values = {-1.9, 0.3, 0, 1.1, -0.2, 0};
  for (Field& field : s.fields)
    if (field.name == "SmoothingLength") field.values = {0.25, 0.125};
  return s;
}

TEST(ReadersBox, AnOpenAxisHoldsTheBoxAndEverySupport) {
  const ReadersBox box = readers_box(open_plane());
  EXPECT_DOUBLE_EQ(box.shift[0], 1.9 + 0.25);
  EXPECT_DOUBLE_EQ(box.size[0], 1.9 + 0.25 + 2) << "from the first support to the end of the box";
  EXPECT_DOUBLE_EQ(box.shift[1], 1) << "the box holds all supports";
  EXPECT_DOUBLE_EQ(box.size[1], 2);
  EXPECT_FALSE(box.periodic);
}

TEST(ReadersBox, APlaneLiesInTheMiddleOfAsMuchAsItIsWide) {
  Snapshot s = open_plane();
  const ReadersBox box = readers_box(s);
  EXPECT_DOUBLE_EQ(box.size[2], box.size[0]);
  EXPECT_DOUBLE_EQ(box.placed({0, 0, 0})[2], box.size[0] / 2);
  for (Field& field : s.fields)
    if (field.name == "SmoothingLength") field.values = {10, 10};
  EXPECT_DOUBLE_EQ(readers_box(s).size[2], 1.1 + 10 + 1.9 + 10) << "and no less than two supports";
}

TEST(ReadersBox, APeriodicAxisIsTheRunsOwnBox) {
  Snapshot s = open_plane();
  s.box.periodic = {true, true, false};
  const ReadersBox box = readers_box(s);
  EXPECT_EQ(box.size[0], 4);
  EXPECT_EQ(box.shift, (Array3{2, 1, 2}));
  EXPECT_TRUE(box.periodic);
  EXPECT_EQ(box.placed({2, 0, 0})[0], 0);
  s.box.lower = {0, 0, 0};
  EXPECT_LT(readers_box(s).placed({-1e-17, 0, 0})[0], 4) << "no place is the end of the box, by rounding either";
}

class ShiftedFiles : public Scratch {
 protected:
  std::vector<double> written(const Snapshot& s, const char* dataset) {
    write_snapshot(file("snap.hdf5"), s, example_info());
    return hdf5::File::open(file("snap.hdf5")).dataset(dataset).read<double>();
  }
  std::vector<Array3> read() const { return read_particles(file("snap.hdf5")).particles.x; }
};

TEST_F(ShiftedFiles, ReadersSeeEveryParticleInTheBox) {
  for (const int dimension : {1, 2, 3})
    for (const bool periodic : {false, true}) {
      Snapshot s = example_snapshot(dimension, 500);
      for (int k = 0; k < dimension; ++k) s.box.lower[k] = -0.5, s.box.size[k] = 2, s.box.periodic[k] = periodic;
      const std::vector<double> x = written(s, "PartType0/Coordinates");
      const auto size = hdf5::File::open(file("snap.hdf5")).group("Header").numbers("BoxSize");
      const auto shift = hdf5::File::open(file("snap.hdf5")).group("Header").numbers("Shift");
      for (std::size_t i = 0; i < x.size(); ++i) {
        EXPECT_TRUE(x[i] >= 0 && x[i] < size[i % 3]);
        EXPECT_DOUBLE_EQ(x[i], s.fields[0].values[i] + shift[i % 3]);
      }
    }
}

/// 1e-17 is lost in 0.5 + 1e-17, and comes back.
TEST_F(ShiftedFiles, AreReadBackToTheLastBit) {
  Snapshot s = open_plane();
  s.fields[0].values = {1e-17, -1.0 / 3, 0, 0.1, 0.7, 0};
  for (const bool periodic : {false, true}) {
    s.box.periodic = {periodic, periodic, false};
    const std::vector<double> seen = written(s, "PartType0/Coordinates");
    EXPECT_NE(seen[0], 1e-17);
    EXPECT_EQ(read(), (std::vector<Array3>{{1e-17, -1.0 / 3, 0}, {0.1, 0.7, 0}}));
    const std::vector<double> points = written(s, "VTKHDF/Points");
    EXPECT_EQ(points[0], 1e-17) << "ParaView needs no shift";
    EXPECT_EQ(points[2], seen[2]);
  }
}

TEST_F(ShiftedFiles, NothingIsWrittenTwiceWhereNothingIsMoved) {
  Snapshot s = open_plane();
  s.box = {{0, 0, 0}, {2, 2, 1}, {true, true, false}};
  s.fields[0].values = {0.25, 0.5, 0, 1.5, 1.75, 0};
  write_snapshot(file("snap.hdf5"), s, example_info());
  const auto made = hdf5::File::open(file("snap.hdf5"));
  EXPECT_EQ(made.dataset("VTKHDF/Points").address(), made.dataset("PartType0/Coordinates").address());
  EXPECT_EQ(read(), (std::vector<Array3>{{0.25, 0.5, 0}, {1.5, 1.75, 0}}));
}

/// Somebody sets the second row to where readers see (0.5, 0.25), with the shift of (2, 1): it is not what was written,
/// so the shift is all that is known of it.
TEST_F(ShiftedFiles, RowsThatWereChangedSinceAreMovedBack) {
  Snapshot s = open_plane();
  s.box.periodic = {true, true, false};
  s.fields[0].values = {1e-17, -1.0 / 3, 0, 0.1, 0.7, 0};
  write_snapshot(file("snap.hdf5"), s, example_info());
  std::vector<double> seen = hdf5::File::open(file("snap.hdf5")).dataset("PartType0/Coordinates").read<double>();
  seen[3] = 2.5, seen[4] = 1.25;
  hdf5::Handle made(H5Fopen(file("snap.hdf5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
  const hdf5::Handle x(H5Dopen2(made.get(), "PartType0/Coordinates", H5P_DEFAULT), H5Dclose);
  H5Dwrite(x.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, seen.data());
  H5Fflush(made.get(), H5F_SCOPE_GLOBAL);
  made = hdf5::Handle();
  EXPECT_EQ(read(), (std::vector<Array3>{{1e-17, -1.0 / 3, 0}, {0.5, 0.25, 0}}));
}

TEST_F(ShiftedFiles, RatesHaveTheCoordinatesOfTheRun) {
  ParticleSet p;
  p.dimension = 2;
  p.box = {{-1, -1, 0}, {2, 2, 1}, {true, true, false}};
  p.x = {{-0.5, 0.25, 0}, {-1.25, 0.5, 0}};
  write_fields(file("snap.hdf5"), p, {}, 1.4, example_info());
  EXPECT_EQ(hdf5::File::open(file("snap.hdf5")).dataset("PartType0/Coordinates").read<double>(),
            (std::vector<double>{-0.5, 0.25, 0, -1.25, 0.5, 0}));
}

TEST_F(ShiftedFiles, FilesOfOthersAreTakenAsTheyAre) {
  auto made = ExampleIc{}.make();
  made.group("Header").set("Shift", std::vector<double>{1, 1, 1});
  made.save(file("snap.hdf5"));
  EXPECT_EQ(read()[1], (Array3{3.0 / 64, 4.0 / 64, 5.0 / 64}));
}

}  // namespace
}  // namespace sphk
