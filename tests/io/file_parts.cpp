// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/file_parts.hpp"

#include "tests/io/example.hpp"

namespace sphk {
namespace {

class FileParts : public Scratch {
 protected:
  void make(const std::string& name, int parts) const {
    auto made = hdf5::File::create();
    made.create_group("Header").set("NumFilesPerSnapshot", std::int32_t{parts});
    made.save(file(name));
  }
};

TEST_F(FileParts, OneFileStandsAlone) {
  make("x.hdf5", 1);
  make("x.0.hdf5", 1);
  EXPECT_EQ(file_parts(file("x.hdf5")), std::vector{file("x.hdf5")});
  EXPECT_EQ(file_parts(file("x.0.hdf5")), std::vector{file("x.0.hdf5")});
}

TEST_F(FileParts, AnyPartFindsAllInNumericalOrder) {
  std::vector<std::filesystem::path> all;
  for (int i = 0; i < 11; ++i) {
    all.push_back(file("x_3." + std::to_string(i) + ".h5"));
    make(all.back().filename(), 11);
  }
  EXPECT_EQ(file_parts(all[7]), all);
}

TEST_F(FileParts, APartMustHaveANumber) {
  make("x.hdf5", 2);
  EXPECT_TRUE(mentions(input_error([&] { file_parts(file("x.hdf5")); }), {"x.hdf5", "2 parts", "NumFilesPerSnapshot"}));
}

}  // namespace
}  // namespace sphk
