// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/atomic_file.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "tests/io/example.hpp"

namespace sphk {
namespace {

using AtomicFile = Scratch;

std::string content(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST_F(AtomicFile, MakesAndReplaces) {
  write_atomically(file("a"), std::string_view("one\0two", 7));
  EXPECT_EQ(content(file("a")), std::string("one\0two", 7));
  write_atomically(file("a"), "");
  EXPECT_EQ(content(file("a")), "");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(AtomicFile, NamesWithoutAFolderAreInTheCurrentOne) {
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder_);
  write_atomically("here", "text");
  std::filesystem::current_path(before);
  EXPECT_EQ(content(file("here")), "text");
}

TEST_F(AtomicFile, ALinkOfTheTemporaryNameIsNotFollowed) {
  std::ofstream(file("other")) << "mine";
  std::filesystem::create_symlink(file("other"), file(".a." + std::to_string(getpid()) + ".tmp"));
  write_atomically(file("a"), "text");
  EXPECT_EQ(content(file("a")), "text");
  EXPECT_EQ(content(file("other")), "mine");
}

TEST_F(AtomicFile, WhatStandsInTheWayIsLeftAlone) {
  std::filesystem::create_directories(file("a") / "b");
  EXPECT_TRUE(mentions(input_error([&] { write_atomically(file("a"), "text"); }), {"/a", "irectory"}));
  EXPECT_TRUE(std::filesystem::exists(file("a") / "b"));
  mkfifo(file("pipe").c_str(), 0600);  // as a device would be
  EXPECT_TRUE(mentions(input_error([&] { write_atomically(file("pipe"), "text"); }), {"/pipe", "device"}));
  EXPECT_TRUE(std::filesystem::is_fifo(file("pipe")));
  std::filesystem::remove(file("pipe"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

}  // namespace
}  // namespace sphk
