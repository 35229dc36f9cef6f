// SPDX-License-Identifier: BSD-3-Clause

// The readers of HDF5 files: initial conditions, snapshots and checkpoints.
#include "src/io/check.hpp"
#include "src/io/checkpoint.hpp"
#include "src/io/info.hpp"
#include "src/io/reader.hpp"
#include "tests/fuzz/input_file.hpp"

// What HDF5 itself does with wrong bytes is overlooked, as in tests/io/damaged_files.cpp, so far as it survives it; of
// our own code no allocation passes 256 MB, which is far more than any file of the corpus needs.
// NOLINTBEGIN(bugprone-reserved-identifier): the names are theirs
extern "C" const char* __asan_default_options() {
  return "allocator_may_return_null=1:max_allocation_size_mb=256";
}
extern "C" const char* __asan_default_suppressions() {
  return "interceptor_via_lib:libhdf5";
}
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libhdf5";
}
// NOLINTEND(bugprone-reserved-identifier)

namespace sphk {
namespace {

void check(const std::filesystem::path& path) {
  for (const Finding& finding : check_particles(read_particles(path, NonFinite::keep).particles)) to_text(finding);
}

}  // namespace
}  // namespace sphk

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const sphk::InputFile file(".0.hdf5");
  file.put(data, size);
  sphk::expect_input_error_or_none([] { sphk::file_info(file.path()); });
  sphk::expect_input_error_or_none([] { sphk::read_particles(file.path()); });
  sphk::expect_input_error_or_none([] { sphk::check(file.path()); });
  sphk::expect_input_error_or_none([] { sphk::read_checkpoint(file.path()); });
  return 0;
}
