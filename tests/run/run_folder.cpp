// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/run_folder.hpp"

#include <gtest/gtest.h>

#include "src/engine/errors.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

namespace fs = std::filesystem;

void touch(const fs::path& path) {
  std::ofstream(path) << "x";
}

TEST(RunFolder, WithoutANameTakesTheNextFreeOne) {
  const TemporaryFolder folder;
  const std::string scene = (folder.path() / "sod").string();
  EXPECT_EQ(make_run_folder(scene, {}).path, scene + "-run");
  EXPECT_EQ(make_run_folder(scene, {}).path, scene + "-run-2");
  EXPECT_EQ(make_run_folder(scene, {}).path, scene + "-run-3");
}

TEST(RunFolder, AnAskedFolderIsMadeWithItsParents) {
  const TemporaryFolder folder;
  EXPECT_TRUE(fs::is_directory(make_run_folder("sod", {.asked = folder.path() / "a" / "b"}).path));
}

TEST(RunFolder, APreviousRunIsNotTouchedUnlessAsked) {
  const TemporaryFolder folder;
  touch(folder.path() / "snap_0000.hdf5");
  EXPECT_THROW(make_run_folder("sod", {.asked = folder.path()}), InputError);
  EXPECT_THROW(refuse_used_folder({.asked = folder.path()}), InputError);
  EXPECT_TRUE(fs::exists(folder.path() / "snap_0000.hdf5"));
}

TEST(RunFolder, OverwriteRemovesTheRunAndNothingElse) {
  const TemporaryFolder folder;
  for (const char* name : {"snap_0000.hdf5", "snap_0000.png", "run.json", "history.csv", "notes.txt", "my.hdf5"})
    touch(folder.path() / name);
  make_run_folder("sod", {.asked = folder.path(), .overwrite = true});
  EXPECT_TRUE(fs::exists(folder.path() / "notes.txt"));
  EXPECT_TRUE(fs::exists(folder.path() / "my.hdf5"));
  for (const char* name : {"snap_0000.hdf5", "snap_0000.png", "run.json", "history.csv"})
    EXPECT_FALSE(fs::exists(folder.path() / name)) << name;
}

TEST(RunFolder, WhatIsLeftOfAnOverwriteThatFailsIsNoRun) {
  const TemporaryFolder folder;
  for (const char* name : {"run.json", "checkpoint_a.hdf5", "checkpoint_b.hdf5"}) touch(folder.path() / name);
  for (int k = 0; k < 50; ++k) {  // folders with something in them, which are not removed
    const fs::path stays = folder.path() / ("snap_" + std::to_string(k) + ".hdf5");
    fs::create_directory(stays);
    touch(stays / "file");
  }
  EXPECT_THROW(make_run_folder("sod", {.asked = folder.path(), .overwrite = true}), InputError);
  for (const char* name : {"run.json", "checkpoint_a.hdf5", "checkpoint_b.hdf5"})
    EXPECT_FALSE(fs::exists(folder.path() / name)) << name;
}

TEST(RunFolder, AFolderThatIsNotOursOnlyHoldsOtherFiles) {
  const TemporaryFolder folder;
  touch(folder.path() / "notes.txt");
  EXPECT_EQ(make_run_folder("sod", {.asked = folder.path()}).path, folder.path());
}

TEST(RunFolder, APlaceThatCannotBeMadeIsAnInputError) {
  const TemporaryFolder folder;
  touch(folder.path() / "file");
  EXPECT_THROW(make_run_folder("sod", {.asked = folder.path() / "file" / "below"}), InputError);
}

}  // namespace
}  // namespace sphk
