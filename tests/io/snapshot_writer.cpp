// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/snapshot_writer.hpp"

#include <sys/resource.h>

#include <csignal>
#include <fstream>

#include "src/io/kernel_gamma.hpp"
#include "src/io/reader.hpp"
#include "tests/io/example.hpp"

namespace sphk {
namespace {

using SnapshotWriter = Scratch;

void expect_equal(const ParticleSet& p, const Snapshot& s) {
  ASSERT_EQ(p.size(), s.size());
  EXPECT_EQ(p.dimension, s.dimension);
  EXPECT_EQ(p.time, s.time);
  EXPECT_EQ(p.box.lower, s.box.lower);
  EXPECT_EQ(p.box.size, s.box.size);
  EXPECT_EQ(p.box.periodic, s.box.periodic);
  EXPECT_EQ(p.id, s.id);
  EXPECT_EQ(p.m, s.field("Masses").values);
  EXPECT_EQ(p.u, s.field("InternalEnergies").values);
  EXPECT_EQ(p.h, s.field("SmoothingLength").values);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(p.x[i][k], s.field("Coordinates").values[3 * i + k]);
      EXPECT_EQ(p.v[i][k], s.field("Velocities").values[3 * i + k]);
    }
}

TEST_F(SnapshotWriter, IsReadBackBitForBit) {
  for (const int dimension : {1, 2, 3})
    for (const auto compression : {Compression::none, Compression::gzip})
      for (const std::size_t n : {std::size_t{0}, std::size_t{1}, std::size_t{1000}}) {
        SCOPED_TRACE(testing::Message() << dimension << "D, " << n << " particles");
        const Snapshot s = example_snapshot(dimension, n);
        write_snapshot(file("snap.hdf5"), s, example_info(), compression);
        const ReadResult read = read_particles(file("snap.hdf5"));
        expect_equal(read.particles, s);
        EXPECT_EQ(read.gamma, 1.4);
        EXPECT_TRUE(read.own_snapshot);
        EXPECT_TRUE(read.remarks.empty() || n == 0);
      }
}

TEST_F(SnapshotWriter, PeriodicAxesAreKeptOneByOne) {
  Snapshot s = example_snapshot(3, 4);
  s.box.periodic = {true, false, true};
  write_snapshot(file("snap.hdf5"), s, example_info());
  EXPECT_EQ(read_particles(file("snap.hdf5")).particles.box.periodic, s.box.periodic);
}

TEST_F(SnapshotWriter, CompressionMakesRegularFieldsSmaller) {
  Snapshot s = example_snapshot(3, 20000);
  for (Field& f : s.fields) std::fill(f.values.begin(), f.values.end(), 0.25);
  write_snapshot(file("plain.hdf5"), s, example_info());
  write_snapshot(file("small.hdf5"), s, example_info(), Compression::gzip);
  EXPECT_LT(std::filesystem::file_size(file("small.hdf5")) * 10, std::filesystem::file_size(file("plain.hdf5")));
}

TEST_F(SnapshotWriter, SwiftsSmoothingLengthIsTheSupportOverKernelGamma) {
  const Snapshot s = example_snapshot(2, 5);
  write_snapshot(file("snap.hdf5"), s, example_info());
  const auto h = hdf5::File::open(file("snap.hdf5")).dataset("PartType0/SmoothingLengths").read<double>();
  for (std::size_t i = 0; i < h.size(); ++i)
    EXPECT_DOUBLE_EQ(h[i] * kernel_gamma("cs", 2), s.field("SmoothingLength").values[i]);
}

TEST_F(SnapshotWriter, RatesKeepTheParticlesOrder) {
  ParticleSet p;
  p.x = {{0.5, 0, 0}, {0.25, 0, 0}};
  p.id = {9, 4};
  p.time = 2;
  const std::vector<Field> fields{{"Density", "", {-3, 1, 0}, 1, {3, 7}},
                                  {"Acceleration", "", {1, 0, -2}, 3, {1, 2, 3, 4, 5, 6}}};
  write_fields(file("rates.hdf5"), p, fields, 1.4, example_info());
  const auto gas = hdf5::File::open(file("rates.hdf5")).group("PartType0");
  EXPECT_EQ(gas.dataset("ParticleIDs").read<std::uint64_t>(), p.id);
  EXPECT_EQ(gas.dataset("Density").read<double>(), (std::vector<double>{3, 7}));
  EXPECT_EQ(gas.dataset("Acceleration").shape(), (std::vector<hsize_t>{2, 3}));
  EXPECT_EQ(gas.dataset("Coordinates").read<double>(), (std::vector<double>{0.5, 0, 0, 0.25, 0, 0}));
}

TEST_F(SnapshotWriter, FieldsOfAWrongSizeAreRefused) {
  Snapshot s = example_snapshot(3, 4);
  s.fields[2].values.pop_back();
  EXPECT_TRUE(mentions(input_error([&] { write_snapshot(file("snap.hdf5"), s, example_info()); }),
                       {"Masses", "3 values", "4 particles"}));
  EXPECT_FALSE(std::filesystem::exists(file("snap.hdf5")));
}

/// A field that makes its values when they are asked for is written as one that has them.
TEST_F(SnapshotWriter, FieldsAreMadeWhenTheyAreWritten) {
  const Snapshot s = example_snapshot(3, 40);
  Snapshot view = s;
  for (Field& field : view.fields) field.make = [values = std::exchange(field.values, {})] { return values; };
  write_snapshot(file("snap.hdf5"), s, example_info());
  write_snapshot(file("view.hdf5"), view, example_info());
  EXPECT_EQ(read_text(file("view.hdf5")).size(), read_text(file("snap.hdf5")).size());
  const hdf5::File a = hdf5::File::open(file("snap.hdf5")), b = hdf5::File::open(file("view.hdf5"));
  for (const std::string& name : a.group("PartType0").members()) {
    const auto path = "PartType0/" + name;
    EXPECT_EQ(b.dataset(path).read<double>(), a.dataset(path).read<double>()) << name;
  }
}

TEST_F(SnapshotWriter, FoldersThatCannotBeWrittenAreNamed) {
  const Snapshot s = example_snapshot(3, 4);
  const auto message = [&](const char* path) { return input_error([&] { write_snapshot(path, s, example_info()); }); };
  EXPECT_TRUE(mentions(message("/no/such/folder/snap.hdf5"), {"/no/such/folder", "mkdir -p"}));
  EXPECT_TRUE(mentions(message("/proc/snap.hdf5"), {"/proc"}));
}

/// A limit on the size of files stands in for a full disk: write() fails half-way in both.
template <class F>
void with_file_size_limit(rlim_t bytes, F call) {
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{bytes, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &limit);
  call();
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);
}

TEST_F(SnapshotWriter, AFullDiskLeavesTheOldFileAndNothingElse) {
  const Snapshot old = example_snapshot(3, 10), s = example_snapshot(3, 20000);
  write_snapshot(file("snap.hdf5"), s, example_info());
  const auto size = std::filesystem::file_size(file("snap.hdf5"));
  write_snapshot(file("snap.hdf5"), old, example_info());
  for (const rlim_t bytes : {rlim_t{100}, rlim_t{3000}, size / 100, size / 2, size - 20'000, size - 1}) {
    with_file_size_limit(bytes, [&] {
      const std::string message = input_error([&] { write_snapshot(file("snap.hdf5"), s, example_info()); });
      EXPECT_TRUE(mentions(message, {"snap.hdf5", "File too large"}));
    });
    expect_equal(read_particles(file("snap.hdf5")).particles, old);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1) << bytes;
  }
  write_snapshot(file("snap.hdf5"), s, example_info());
  expect_equal(read_particles(file("snap.hdf5")).particles, s);
}

TEST_F(SnapshotWriter, SeriesNamesEverySnapshotWithItsTime) {
  const std::vector<SeriesEntry> entries{{"snap_0000.hdf5", 0}, {"snap_0001.hdf5", 0.125}};
  write_series(folder_, entries);
  std::string text = read_text(file("run.hdf.series"));
  std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
  EXPECT_EQ(text, R"({"file-series-version":"1.0","files":[{"name":"snap_0000.hdf5","time":0},)"
                  R"({"name":"snap_0001.hdf5","time":0.125}]})");
}

}  // namespace
}  // namespace sphk
