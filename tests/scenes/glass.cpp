#include "src/scenes/glass.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <complex>

#include "src/engine/errors.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

// Tiles divide the counts; 100 = 4 x 25 in 3D and 2 x 50 in 2D.
TEST(Glass, TilesFillTheBlock) {
  EXPECT_EQ(glass_tile({64, 32, 32}, 3), (Counts{32, 32, 32}));
  EXPECT_EQ(glass_tile({100, 16, 8}, 3), (Counts{25, 16, 8}));
  EXPECT_EQ(glass_tile({100, 64, 1}, 2), (Counts{50, 64, 1}));
  EXPECT_EQ(glass_tile({4, 4, 4}, 3), (Counts{4, 4, 4}));  // small blocks are a glass of their own
  EXPECT_THROW(glass_tile({37, 32, 32}, 3), InputError);   // a prime
  EXPECT_THROW(glass_tile({74, 32, 32}, 3), InputError);   // 2 x 37
}

TEST(Glass, TheStartHasOneParticlePerCellAndIsRepeatable) {
  const auto x = glass_start(2, {6, 5, 1});
  ASSERT_EQ(x.size(), 30u);
  std::set<int> cells;
  for (const Array3& p : x) {
    EXPECT_EQ(p[2], 0);
    cells.insert(int(p[0]) * 5 + int(p[1]));
  }
  EXPECT_EQ(cells.size(), 30u);
  EXPECT_EQ(x, glass_start(2, {6, 5, 1}));
}

// A random shift within a cell has any phase at the lattice's own wavelength: |sum exp(2 pi i x)|^2 / N is of order 1,
// as for random points, and N for a lattice. It exceeds 15 once in exp(15) = 3e6 starts.
TEST(Glass, TheStartHasNoTraceOfTheLattice) {
  const auto x = glass_start(3, {16, 16, 16});
  for (int axis = 0; axis < 3; ++axis) {
    std::complex<double> sum = 0;
    for (const Array3& p : x) sum += std::polar(1.0, 2 * M_PI * p[axis]);
    EXPECT_LT(std::norm(sum) / double(x.size()), 15) << axis;
  }
}

// The relaxer shifts all by more than the box, so that wrapping shows.
TEST(Glass, IsRelaxedOnceAndThenRead) {
  const TemporaryFolder folder;
  int relaxed = 0;
  const Relaxer relax = [&](int dimension, const Array3& size, std::vector<Array3> x) {
    ++relaxed;
    EXPECT_EQ(dimension, 2);
    EXPECT_EQ(size, (Array3{8, 6, 1}));
    for (Array3& p : x) p[0] += 9.25;
    return x;
  };
  const auto first = glass(2, {8, 6, 1}, relax, folder.path() / "new" / "cache");
  const auto second = glass(2, {8, 6, 1}, relax, folder.path() / "new" / "cache");
  EXPECT_EQ(relaxed, 1);
  EXPECT_EQ(first, second);
  const auto start = glass_start(2, {8, 6, 1});
  for (std::size_t i = 0; i < start.size(); ++i) {
    EXPECT_NEAR(first[i][0], std::fmod(start[i][0] + 9.25, 8), 1e-14);
    EXPECT_TRUE(first[i][0] >= 0 && first[i][0] < 8);
  }
}

TEST(Glass, WithoutACacheItIsRelaxedEveryTime) {
  int relaxed = 0;
  const Relaxer relax = [&](int, const Array3&, std::vector<Array3> x) { return ++relaxed, x; };
  glass(2, {4, 4, 1}, relax, {});
  glass(2, {4, 4, 1}, relax, {});
  EXPECT_EQ(relaxed, 2);
}

TEST(Glass, TheCacheFollowsTheEnvironment) {
  const auto restore = [](const char* name) {
    const char* value = std::getenv(name);
    return std::pair<std::string, bool>(value ? value : "", value != nullptr);
  };
  const auto xdg = restore("XDG_CACHE_HOME"), home = restore("HOME");
  setenv("XDG_CACHE_HOME", "/x", 1);
  setenv("HOME", "/h", 1);
  EXPECT_EQ(glass_cache(), "/x/sphk");
  unsetenv("XDG_CACHE_HOME");
  EXPECT_EQ(glass_cache(), "/h/.cache/sphk");
  unsetenv("HOME");
  EXPECT_TRUE(glass_cache().empty());
  if (xdg.second) setenv("XDG_CACHE_HOME", xdg.first.c_str(), 1);
  if (home.second) setenv("HOME", home.first.c_str(), 1);
}

}  // namespace
}  // namespace sphk
