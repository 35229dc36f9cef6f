// SPDX-License-Identifier: BSD-3-Clause
#include <cstring>
#include <fstream>
#include <random>

#include "src/io/info.hpp"
#include "src/io/reader.hpp"
#include "tests/io/example.hpp"

// What HDF5 1.10.8 itself does with the wrong bytes below, while the handles it is given are valid: it asks for as many
// bytes as the file says, up to a million million, and copes when it gets none; it follows lengths behind the end of an
// object header and copies from there; it leaks what it had decoded before it fails. The sanitizers overlook these
// three, here only.
// NOLINTBEGIN(bugprone-reserved-identifier): the names are theirs
extern "C" const char* __asan_default_options() {
  return "allocator_may_return_null=1";
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

/// Files cut short or with wrong bytes: each either reads or gives an InputError, and never anything else.
class DamagedFiles : public Scratch {
 protected:
  std::string bytes_of(const std::filesystem::path& path) const {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void put(const std::string& bytes) const { std::ofstream(file("bad.hdf5"), std::ios::binary) << bytes; }
  /// True when the file is refused; anything but success or an InputError fails the test.
  bool refused() const {
    try {
      file_info(file("bad.hdf5"));
      read_particles(file("bad.hdf5"));
      return false;
    } catch (const InputError& error) {
      EXPECT_FALSE(std::string(error.what()).empty());
      return true;
    }
  }
};

TEST_F(DamagedFiles, EveryTruncationIsRefused) {
  write_snapshot(file("good.hdf5"), example_snapshot(3, 200), example_info());
  const std::string good = bytes_of(file("good.hdf5"));
  put(good);
  EXPECT_FALSE(refused());
  for (std::size_t length = 0; length < good.size(); length += 1 + good.size() / 200) {
    put(good.substr(0, length));
    EXPECT_TRUE(refused()) << length << " of " << good.size() << " bytes";
  }
}

/// A dataset in one piece whose shape and size in the file both say 2^50 bytes: neither may be believed.
TEST_F(DamagedFiles, NoMoreIsAskedForThanTheFileHolds) {
  const auto bytes = [](std::uint64_t number) {
    std::string text(sizeof(number), '\0');
    std::memcpy(text.data(), &number, sizeof(number));
    return text;
  };
  constexpr std::uint64_t size = 12347;
  auto made = hdf5::File::create();
  made.write("Data", std::vector<std::uint8_t>(size));
  made.save(file("good.hdf5"));
  std::string bad = bytes_of(file("good.hdf5"));
  int changed = 0;
  for (auto at = bad.find(bytes(size)); at != std::string::npos; at = bad.find(bytes(size)), ++changed)
    bad.replace(at, sizeof(size), bytes(std::uint64_t{1} << 50));
  ASSERT_GE(changed, 2);
  put(bad);
  const auto read = [&] { hdf5::File::open(file("bad.hdf5")).dataset("Data").read<std::uint8_t>(); };
  EXPECT_TRUE(mentions(input_error(read), {"asks for 1125899906842624 bytes", "but the file holds"}));
}

/// A fixed choice of bytes: for a few in ten thousand of the others HDF5 1.10 reads so far past its buffers that it
/// crashes.
TEST_F(DamagedFiles, WrongBytesAreReadOrRefused) {
  ExampleIc{}.make().save(file("good.hdf5"));
  const std::string good = bytes_of(file("good.hdf5"));
  std::mt19937 random(1);
  std::size_t refusals = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    std::string bad = good;
    bad[random() % bad.size()] ^= static_cast<char>(1 + random() % 255);
    put(bad);
    refusals += refused();
  }
  EXPECT_GT(refusals, 0);
}

}  // namespace
}  // namespace sphk
