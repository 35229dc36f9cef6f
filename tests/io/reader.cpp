// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/reader.hpp"

#include <limits>

#include "tests/io/example.hpp"

namespace sphk {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

class Reader : public Scratch {
 protected:
  ReadResult read(const hdf5::File& made) {
    made.save(file("ic.hdf5"));
    return read_particles(file("ic.hdf5"));
  }
  std::string error_of(const hdf5::File& made) {
    return input_error([&] { read(made); });
  }
  /// The gas that ExampleIc writes, with `columns` components.
  static void expect_example(const ParticleSet& p, std::size_t n, std::size_t columns) {
    ASSERT_EQ(p.size(), n);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double row = static_cast<double>(i * columns + k);
        EXPECT_EQ(p.x[i][k], k < columns ? row / 64 : 0);
        EXPECT_EQ(p.v[i][k], k < columns ? row / 8 : 0);
      }
      EXPECT_EQ(p.m[i], 1 + static_cast<double>(i) / 4);
      EXPECT_EQ(p.u[i], 2 + static_cast<double>(i) / 2);
    }
  }
};

bool remarked(const ReadResult& result, const std::string& part) {
  for (const std::string& remark : result.remarks)
    if (remark.find(part) != std::string::npos) return true;
  return false;
}

TEST_F(Reader, TakesAPlainGadgetFile) {
  const ReadResult result = read(ExampleIc{}.make());
  const ParticleSet& p = result.particles;
  expect_example(p, 8, 3);
  EXPECT_EQ(p.dimension, 3);
  EXPECT_EQ(p.box.size, (Array3{2, 2, 2}));
  EXPECT_EQ(p.box.periodic, (std::array{true, true, true}));
  EXPECT_EQ(p.id, (std::vector<std::uint64_t>{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_TRUE(p.h.empty());
  EXPECT_FALSE(result.gamma);
  EXPECT_FALSE(result.own_snapshot);
  for (const char* part : {"units", "adiabatic index", "periodic", "ParticleIDs", "smoothing lengths"})
    EXPECT_TRUE(remarked(result, part)) << part;
}

TEST_F(Reader, ColumnsOfCoordinatesGiveTheDimension) {
  for (const int columns : {1, 2, 3}) {
    const ParticleSet p = read(ExampleIc{.columns = columns}.make()).particles;
    EXPECT_EQ(p.dimension, columns);
    expect_example(p, 8, static_cast<std::size_t>(columns));
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(p.box.size[k], static_cast<int>(k) < columns ? 2 : 1);
      EXPECT_EQ(p.box.periodic[k], static_cast<int>(k) < columns);
    }
  }
}

TEST_F(Reader, DimensionAttributeWinsAndSaysWhatIsDropped) {
  auto made = ExampleIc{}.make();
  made.group("Header").set("Dimension", std::int32_t{2});
  const ReadResult result = read(made);
  EXPECT_EQ(result.particles.dimension, 2);
  EXPECT_EQ(result.particles.x[1], (Array3{3.0 / 64, 4.0 / 64, 0}));
  EXPECT_TRUE(remarked(result, "beyond 2 dimensions"));
}

TEST_F(Reader, TakesAnyNumberTypeAndColumnShape) {
  auto made = hdf5::File::create();
  made.create_group("Header").set("BoxSize", std::vector<float>{1, 2});
  auto gas = made.create_group("PartType0");
  gas.write("Coordinates", std::vector<float>{0.25f, 0.5f, 0.75f, 1.5f}, 2);
  gas.write("Velocities", std::vector<std::int32_t>{1, 2, 3, -4}, 2);
  gas.write("Masses", std::vector<float>{0.5f, 0.25f}, 1);
  gas.write("InternalEnergies", std::vector<double>{3, 4}, 1);
  gas.write("SmoothingLength", std::vector<float>{0.125f, 0.25f}, 1);
  gas.write("ParticleIDs", std::vector<std::int32_t>{7, 5}, 1);
  const ReadResult result = read(made);
  const ParticleSet& p = result.particles;
  EXPECT_EQ(p.x, (std::vector<Array3>{{0.25, 0.5, 0}, {0.75, 1.5, 0}}));
  EXPECT_EQ(p.v, (std::vector<Array3>{{1, 2, 0}, {3, -4, 0}}));
  EXPECT_EQ(p.m, (std::vector<double>{0.5, 0.25}));
  EXPECT_EQ(p.u, (std::vector<double>{3, 4}));
  EXPECT_EQ(p.h, (std::vector<double>{0.125, 0.25}));
  EXPECT_EQ(p.id, (std::vector<std::uint64_t>{7, 5}));
  EXPECT_EQ(p.box.size, (Array3{1, 2, 1}));
  EXPECT_TRUE(remarked(result, "smoothing lengths are not used"));
}

TEST_F(Reader, MassTableStandsInForMasses) {
  auto made = hdf5::File::create();
  auto header = made.create_group("Header");
  header.set("BoxSize", 1.0);
  header.set("MassTable", std::vector<double>{0.75, 0, 0, 0, 0, 0, 0});
  auto gas = made.create_group("PartType0");
  gas.write("Coordinates", std::vector<double>{0.1, 0.2, 0.3, 0.4, 0.5, 0.6}, 3);
  gas.write("Velocities", std::vector<double>(6), 3);
  gas.write("InternalEnergy", std::vector<double>{1, 1});
  EXPECT_EQ(read(made).particles.m, (std::vector<double>{0.75, 0.75}));
}

TEST_F(Reader, OtherTypesAreNamedAndCounted) {
  auto made = ExampleIc{}.make();
  made.create_group("PartType1").write("Coordinates", std::vector<double>(15), 3);
  made.create_group("PartType6").write("Coordinates", std::vector<double>(6), 3);
  const ReadResult result = read(made);
  EXPECT_EQ(result.particles.size(), 8);
  EXPECT_TRUE(remarked(result, "2 particles of PartType6"));
  EXPECT_FALSE(remarked(result, "PartType1"));  // NumPart_ThisFile has 0 of them: the Header is what counts

  auto groupless = hdf5::File::create();
  auto header = groupless.create_group("Header");
  header.set("NumPart_ThisFile", std::vector<std::int64_t>{0, 12, 0, 0, 3, 0, 0});
  EXPECT_TRUE(mentions(error_of(groupless), {"ic.hdf5", "no gas", "PartType0"}));
}

TEST_F(Reader, OpensTheBoxWhereThereIsNoBoxSize) {
  auto made = hdf5::File::create();
  made.create_group("Header");
  auto gas = made.create_group("PartType0");
  gas.write("Coordinates", std::vector<double>{-1, 2, 0.5, 3, 2, 0.25}, 3);
  gas.write("Velocities", std::vector<double>(6), 3);
  gas.write("Masses", std::vector<double>{1, 1});
  gas.write("InternalEnergy", std::vector<double>{1, 1});
  const ReadResult result = read(made);
  EXPECT_EQ(result.particles.box.lower, (Array3{-1, 2, 0.25}));
  EXPECT_EQ(result.particles.box.size, (Array3{4, 1, 0.25}));  // all y are equal: any size will do, 1 it is
  EXPECT_EQ(result.particles.box.periodic, (std::array{false, false, false}));
  EXPECT_TRUE(remarked(result, "open"));
}

TEST_F(Reader, TakesSwiftsFlagsOfPeriodicityAndGamma) {
  auto made = ExampleIc{}.make();
  made.create_group("RuntimePars").set("PeriodicBoundariesOn", std::int32_t{0});
  made.create_group("HydroScheme").set("Adiabatic index", 1.4);
  made.group("Header").set("Time", 0.5);
  const ReadResult result = read(made);
  EXPECT_EQ(result.particles.box.periodic, (std::array{false, false, false}));
  EXPECT_EQ(result.gamma, 1.4);
  EXPECT_EQ(result.particles.time, 0.5);
  EXPECT_FALSE(remarked(result, "periodic"));
}

TEST_F(Reader, ZeroSmoothingLengthsAreLeftToTheEngine) {
  auto made = ExampleIc{}.make();
  made.group("PartType0").write("SmoothingLength", std::vector<double>(8, 0.0));
  EXPECT_TRUE(read(made).particles.h.empty());
}

TEST_F(Reader, SeveralFilesMakeOneSet) {
  for (int part = 0; part < 3; ++part) {
    auto made = ExampleIc{.n = 4}.make();
    made.group("Header").set("NumFilesPerSnapshot", std::int32_t{3});
    made.group("PartType0").write("ParticleIDs", std::vector<std::uint32_t>(4, static_cast<std::uint32_t>(part)));
    made.save(file("set." + std::to_string(part) + ".hdf5"));
  }
  for (const char* name : {"set.0.hdf5", "set.2.hdf5", "set.hdf5", "set"}) {
    const ParticleSet p = read_particles(file(name)).particles;
    EXPECT_EQ(p.id, (std::vector<std::uint64_t>{0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2})) << name;
    EXPECT_EQ(p.m[5], 1.25);
  }
  std::filesystem::remove(file("set.1.hdf5"));
  EXPECT_TRUE(mentions(input_error([&] { read_particles(file("set.0.hdf5")); }), {"set.1.hdf5", "missing"}));
}

TEST_F(Reader, NonFiniteNumbersHaveAPlace) {
  auto made = hdf5::File::create();
  made.create_group("Header").set("BoxSize", 1.0);
  auto gas = made.create_group("PartType0");
  gas.write("Coordinates", std::vector<double>{0.1, 0.2, 0.3, 0.4, nan, 0.6}, 3);
  gas.write("Velocities", std::vector<double>(6), 3);
  gas.write("Masses", std::vector<double>{1, 1});
  gas.write("InternalEnergy", std::vector<double>{1, 1});
  EXPECT_TRUE(mentions(error_of(made), {"ic.hdf5", "Coordinates", "row 1", "nan", "ic check"}));
  EXPECT_EQ(read_particles(file("ic.hdf5"), NonFinite::keep).particles.x[1][2], 0.6);
}

TEST_F(Reader, WhatDoesNotFitIsNamed) {
  const auto with = [](auto change) {
    auto made = ExampleIc{}.make();
    change(made);
    return made;
  };
  const auto extra = [&](const char* name, auto values, hsize_t columns) {
    return with([&](hdf5::File& made) { made.group("PartType0").write(name, values, columns); });
  };
  const auto header = [&](const char* name, auto value) {
    return with([&](hdf5::File& made) { made.group("Header").set(name, value); });
  };
  const std::vector<std::int64_t> negative{1, 2, -3, 4, 5, 6, 7, 8};
  EXPECT_TRUE(mentions(error_of(extra("ParticleIDs", negative, 0)), {"ParticleIDs", "row 2", "-3", "renumber"}));
  EXPECT_TRUE(mentions(error_of(extra("ParticleIDs", std::vector<double>(8), 0)), {"ParticleIDs", "integers"}));
  EXPECT_TRUE(mentions(error_of(extra("ParticleIDs", std::vector<int>(7), 0)), {"ParticleIDs", "(7)", "8 rows"}));
  EXPECT_TRUE(mentions(error_of(extra("SmoothingLength", std::vector<double>(16), 2)), {"(8, 2)", "(n) or (n, 1)"}));
  EXPECT_TRUE(mentions(error_of(header("Dimension", 4.0)), {"Dimension is 4", "3 columns"}));
  EXPECT_TRUE(mentions(error_of(header("Flag_Entropy_ICs", 1)), {"Flag_Entropy_ICs", "thermal energies"}));
  EXPECT_TRUE(mentions(error_of(header("Time", nan)), {"Time", "finite"}));
  const auto comoving = with([](hdf5::File& made) { made.create_group("Cosmology").set("Cosmological run", 1); });
  EXPECT_TRUE(mentions(error_of(comoving), {"comoving", "Cosmological run"}));
}

TEST_F(Reader, SmoothingLengthsOfZeroAreToBeFound) {
  const auto with = [&](std::vector<double> h) {
    auto made = ExampleIc{}.make();
    made.group("PartType0").write("SmoothingLength", h);
    return read(made);
  };
  const ReadResult all = with(std::vector<double>(8));
  EXPECT_TRUE(all.particles.h.empty());
  EXPECT_TRUE(remarked(all, "they will be found"));
  const std::vector<double> most{1, 1, 0, 1, 1, 1, -1, 1};
  const ReadResult some = with(most);
  EXPECT_EQ(some.particles.h, most) << "check_particles complains of the negative one";
  EXPECT_TRUE(remarked(some, "smoothing lengths of 0 (1 of 8) will be found"));
}

TEST_F(Reader, AnIndexThatIsOneIsRemarkedOn) {
  auto made = ExampleIc{}.make();
  made.create_group("HydroScheme").set("Adiabatic index", 1.0);
  const ReadResult isothermal = read(made);
  EXPECT_FALSE(isothermal.gamma);
  EXPECT_TRUE(remarked(isothermal, "adiabatic index 1 is not above 1"));
}

TEST_F(Reader, MissingPiecesAreNamed) {
  auto empty = hdf5::File::create();
  EXPECT_TRUE(mentions(error_of(empty), {"ic.hdf5", "Header"}));
  auto bare = hdf5::File::create();
  bare.create_group("Header").set("BoxSize", -1.0);
  EXPECT_TRUE(mentions(error_of(bare), {"BoxSize", "-1"}));
  auto made = hdf5::File::create();
  made.create_group("Header");
  auto gas = made.create_group("PartType0");
  EXPECT_TRUE(mentions(error_of(made), {"/PartType0", "Coordinates"}));
  gas.write("Coordinates", std::vector<double>(6), 3);
  EXPECT_TRUE(mentions(error_of(made), {"Velocities or Velocity", "it has Coordinates"}));
  gas.write("Velocities", std::vector<double>(6), 3);
  gas.write("InternalEnergy", std::vector<double>(2));
  EXPECT_TRUE(mentions(error_of(made), {"Masses or Mass"}));
}

TEST_F(Reader, NumberOfParticlesMustAgreeWithTheHeader) {
  auto made = hdf5::File::create();
  made.create_group("Header").set("NumPart_ThisFile", std::vector<int>{5, 0});
  auto gas = made.create_group("PartType0");
  gas.write("Coordinates", std::vector<double>(12), 3);
  gas.write("Velocities", std::vector<double>(12), 3);
  gas.write("Masses", std::vector<double>(4));
  gas.write("InternalEnergy", std::vector<double>(4));
  EXPECT_TRUE(mentions(error_of(made), {"NumPart_ThisFile says 5", "has 4"}));
}

TEST_F(Reader, WhatIsNoFileIsSaid) {
  EXPECT_TRUE(mentions(input_error([&] { read_particles(file("none.hdf5")); }), {"none.hdf5", "no such file"}));
  EXPECT_TRUE(mentions(input_error([&] { read_particles(folder_); }), {"folder"}));
  EXPECT_TRUE(mentions(input_error([&] { read_particles("/dev/null"); }), {"/dev/null", "a device"}));
}

}  // namespace
}  // namespace sphk
