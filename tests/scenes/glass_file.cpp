#include "src/scenes/glass_file.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

const std::vector<Array3> points{{0.25, 1.5, 0}, {1.75, 0.125, 0}, {0.5, 0.5, 0}, {1, 1, 0}};

TEST(GlassFile, NamesSayTheShape) {
  EXPECT_EQ(glass_file_name(3, {32, 16, 8}), "glass-3d-32x16x8-v1.bin");
  EXPECT_EQ(glass_file_name(2, {64, 32, 1}), "glass-2d-64x32-v1.bin");
}

TEST(GlassFile, ReadsWhatItWrote) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "glass.bin";
  write_glass(file, 2, {2, 2, 1}, points);
  EXPECT_EQ(read_glass(file, 2, {2, 2, 1}), points);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1) << "the temporary file is gone";
}

TEST(GlassFile, RefusesAnotherShape) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "glass.bin";
  write_glass(file, 2, {2, 2, 1}, points);
  EXPECT_FALSE(read_glass(file, 2, {4, 1, 1}));
  EXPECT_FALSE(read_glass(file, 3, {2, 2, 1}));
  EXPECT_FALSE(read_glass(folder.path() / "absent", 2, {2, 2, 1}));
}

TEST(GlassFile, RefusesDamage) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "glass.bin";
  write_glass(file, 2, {2, 2, 1}, points);
  const auto size = std::filesystem::file_size(file);
  {
    std::fstream out(file, std::ios::in | std::ios::out | std::ios::binary);
    out.seekp(long(size) - 20);
    out.put('!');
  }
  EXPECT_FALSE(read_glass(file, 2, {2, 2, 1}));
  write_glass(file, 2, {2, 2, 1}, points);
  std::filesystem::resize_file(file, size - 1);
  EXPECT_FALSE(read_glass(file, 2, {2, 2, 1}));
  std::filesystem::resize_file(file, size + 1);
  EXPECT_FALSE(read_glass(file, 2, {2, 2, 1}));
}

TEST(GlassFile, AFolderThatCannotBeIsNoError) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "file").put('x');
  EXPECT_NO_THROW(write_glass(folder.path() / "file" / "glass.bin", 2, {2, 2, 1}, points));
}

}  // namespace
}  // namespace sphk
