#include <fstream>
#include <random>

#include "src/io/info.hpp"
#include "src/io/reader.hpp"
#include "tests/io/example.hpp"

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

/// A fixed choice of bytes: HDF5 1.10 itself reads past its buffers for a few in ten thousand of the others.
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
