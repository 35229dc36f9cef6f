// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <string>

#include "src/engine/errors.hpp"
#include "src/engine/particle_set.hpp"
#include "src/io/hdf5_file.hpp"
#include "src/io/snapshot_writer.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {

/// A snapshot of n particles with numbers that no short decimal equals, so that only exact copies compare equal.
Snapshot example_snapshot(int dimension, std::size_t n);
SnapshotInfo example_info();

/// An initial condition of n gas particles as a plain script would write it: GADGET's names, Header and PartType0 only.
/// In memory: to be changed, then saved.
struct ExampleIc {
  std::size_t n = 8;
  int columns = 3;
  hdf5::File make() const;
};

/// A test with a folder of its own.
class Scratch : public testing::Test {
  TemporaryFolder temporary_;

 protected:
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }
  const std::filesystem::path& folder_ = temporary_.path();
};

/// The message of the InputError that `call` throws; fails the test when it throws none.
std::string input_error(const std::function<void()>& call);

/// True when `text` holds every one of `parts`.
testing::AssertionResult mentions(const std::string& text, const std::vector<std::string>& parts);

}  // namespace sphk
