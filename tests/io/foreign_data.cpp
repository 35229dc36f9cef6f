// SPDX-License-Identifier: BSD-3-Clause

// Datasets as other programs store them: in other files, in other numbers, in larger numbers of them, under a lock.
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "src/io/reader.hpp"
#include "tests/io/example.hpp"

namespace sphk {
namespace {

using hdf5::Handle;

Handle simple(std::vector<hsize_t> shape) {
  return {H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose};
}

class ForeignData : public Scratch {
 protected:
  /// An HDF5 file made with the C API alone.
  Handle make(const std::string& name) const {
    return {H5Fcreate(file(name).c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose};
  }
  /// "whole.hdf5" with a dataset x of 6 rows, of which `parts` files hold two each.
  void make_virtual(int parts) const {
    const Handle space = simple({6}), source = simple({2}), properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    for (int part = 0; part < parts; ++part) {
      const hsize_t start = 2 * static_cast<hsize_t>(part), count = 2;
      H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, &start, nullptr, &count, nullptr);
      const std::string name = "part." + std::to_string(part) + ".hdf5";
      H5Pset_virtual(properties.get(), space.get(), name.c_str(), "x", source.get());
      write_part(part, {10.0 * part, 10.0 * part + 1});
    }
    H5Sselect_all(space.get());
    const Handle whole = make("whole.hdf5");
    const Handle made(
        H5Dcreate2(whole.get(), "x", H5T_NATIVE_DOUBLE, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
        H5Dclose);
  }
  void write_part(int part, const std::vector<double>& values) const {
    auto made = hdf5::File::create();
    made.write("x", values);
    made.save(file("part." + std::to_string(part) + ".hdf5"));
  }
  std::vector<double> read(const std::string& name) const {
    return hdf5::File::open(file(name)).dataset("x").read<double>();
  }
};

TEST_F(ForeignData, VirtualDatasetsAreReadFromTheirParts) {
  make_virtual(3);
  EXPECT_EQ(read("whole.hdf5"), (std::vector<double>{0, 1, 10, 11, 20, 21}));
}

TEST_F(ForeignData, WhatAVirtualDatasetLacksIsNamed) {
  make_virtual(3);
  std::filesystem::remove(file("part.1.hdf5"));
  EXPECT_TRUE(mentions(input_error([&] { read("whole.hdf5"); }), {"whole.hdf5: /x", "part.1.hdf5", "is missing"}));
  write_part(1, {10});
  EXPECT_TRUE(mentions(input_error([&] { read("whole.hdf5"); }), {"part.1.hdf5: /x", "as many rows"}));
  make_virtual(2);
  EXPECT_TRUE(mentions(input_error([&] { read("whole.hdf5"); }), {"whole.hdf5: /x", "4 of its 6 values"}));
}

/// IEEE's half precision: 1 bit of sign, 5 of exponent, 10 of mantissa.
Handle half() {
  Handle type(H5Tcopy(H5T_IEEE_F32LE), H5Tclose);
  H5Tset_fields(type.get(), 15, 10, 5, 0, 10);
  H5Tset_size(type.get(), 2);
  H5Tset_ebias(type.get(), 15);
  return type;
}

/// 9 bits of mantissa, as one of SWIFT's lossy filters keeps them of a float: the rest of its 32 bits are padding.
Handle short_mantissa() {
  Handle type(H5Tcopy(H5T_IEEE_F32LE), H5Tclose);
  H5Tset_fields(type.get(), 17, 9, 8, 0, 9);
  H5Tset_precision(type.get(), 18);
  return type;
}

TEST_F(ForeignData, AllNumbersAreRead) {
  const std::vector<double> values{0, 1, 2.5, 100};  // 2.5 is exact in half precision and with 9 bits
  const std::vector<double> whole{0, 1, 2, 100};
  const auto expect = [&](const Handle& type, const std::vector<double>& wanted) {
    {
      const Handle made = make("x.hdf5"), space = simple({4});
      const Handle x(H5Dcreate2(made.get(), "x", type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                     H5Dclose);
      ASSERT_GE(H5Dwrite(x.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, wanted.data()), 0);
    }
    EXPECT_EQ(read("x.hdf5"), wanted);
  };
  expect(half(), values);
  expect(short_mantissa(), values);
  expect(Handle(H5Tcopy(H5T_NATIVE_LDOUBLE), H5Tclose), values);
  for (const hid_t type : {H5T_STD_I8LE, H5T_STD_U8BE, H5T_STD_I16LE, H5T_STD_U16BE, H5T_STD_I32BE, H5T_STD_U32LE,
                           H5T_STD_I64BE, H5T_STD_U64LE})
    expect(Handle(H5Tcopy(type), H5Tclose), whole);
  Handle bits(H5Tcopy(H5T_STD_U64LE), H5Tclose);
  H5Tset_precision(bits.get(), 36);  // SWIFT's Nbit36
  expect(bits, whole);
}

TEST_F(ForeignData, MoreParticlesThanCanBeCountedAreRefusedUnread) {
  hdf5::File made = hdf5::File::create();
  made.create_group("Header").set("BoxSize", 1.0);
  made.create_group("PartType0");
  made.save(file("many.hdf5"));
  {
    const Handle many(H5Fopen(file("many.hdf5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
    const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose), space = simple({hsize_t{1} << 31, 3});
    const hsize_t chunk[] = {1024, 3};
    H5Pset_chunk(properties.get(), 2, chunk);
    const Handle x(H5Dcreate2(many.get(), "PartType0/Coordinates", H5T_NATIVE_DOUBLE, space.get(), H5P_DEFAULT,
                              properties.get(), H5P_DEFAULT),
                   H5Dclose);
  }
  EXPECT_TRUE(mentions(input_error([&] { read_particles(file("many.hdf5")); }),
                       {"many.hdf5", "2147483648 gas particles", "2147483647"}));
}

TEST_F(ForeignData, ALockedFileIsSaidToBeLocked) {
  ExampleIc{}.make().save(file("ic.hdf5"));
  const int other = open(file("ic.hdf5").c_str(), O_RDONLY);
  ASSERT_EQ(flock(other, LOCK_EX), 0);
  EXPECT_TRUE(mentions(input_error([&] { read_particles(file("ic.hdf5")); }),
                       {"ic.hdf5", "locked", "HDF5_USE_FILE_LOCKING=FALSE"}));
  close(other);
  EXPECT_EQ(read_particles(file("ic.hdf5")).particles.size(), 8);
}

}  // namespace
}  // namespace sphk
