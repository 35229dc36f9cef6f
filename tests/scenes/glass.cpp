// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/glass.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <complex>
#include <fstream>

#include "kernels/smoothing/cubic_spline.hpp"
#include "src/engine/errors.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

// Tiles divide the counts; 100 = 4 x 25 in 3D and 2 x 50 in 2D.
TEST(Glass, TilesFillTheBlock) {
  EXPECT_EQ(glass_tile({64, 32, 32}, 3), (GridCounts{32, 32, 32}));
  EXPECT_EQ(glass_tile({100, 16, 8}, 3), (GridCounts{25, 16, 8}));
  EXPECT_EQ(glass_tile({100, 64, 1}, 2), (GridCounts{50, 64, 1}));
  EXPECT_EQ(glass_tile({4, 4, 4}, 3), (GridCounts{4, 4, 4}));  // small blocks are a glass of their own
  EXPECT_THROW(glass_tile({37, 32, 32}, 3), InputError);       // a prime
  EXPECT_THROW(glass_tile({74, 32, 32}, 3), InputError);       // 2 x 37
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
    EXPECT_NEAR(std::remainder(first[i][0] - start[i][0] - 9.25, 8), 0,
                0.5001 * 8 / 65536);  // half of what files round to
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

/// Root mean square of density / mean density - 1 in a periodic square, by the sum over all pairs, support radius 3.
double density_scatter(const std::vector<Array3>& x, double size) {
  double sum = 0, squares = 0;
  for (const Array3& a : x) {
    double rho = 0;
    for (const Array3& b : x) {
      const double dx = std::remainder(a[0] - b[0], size), dy = std::remainder(a[1] - b[1], size);
      rho += CubicSpline{}.w(std::hypot(dx, dy) / 3);
    }
    sum += rho;
    squares += rho * rho;
  }
  const double mean = sum / double(x.size());
  return std::sqrt(squares / double(x.size()) / (mean * mean) - 1);
}

// Glasses of classic SPH have density scatters below a per cent; the random start has ten times that. The lattice's own
// wavelength holds |sum exp(2 pi i x)|^2 = N^2 in a crystal and of order N without one.
TEST(GlassRelaxation, MakesAnEvenArrangementThatIsNoLattice) {
  constexpr int side = 24;
  const GridCounts counts{side, side, 1};
  const auto start = glass_start(2, counts);
  const auto relaxed = relax_with_engine(2, {side, side, 1}, start);
  ASSERT_EQ(relaxed.size(), start.size());
  EXPECT_GT(density_scatter(start, side), 0.05);
  EXPECT_LT(density_scatter(relaxed, side), 0.01);
  for (int axis = 0; axis < 2; ++axis) {
    std::complex<double> sum = 0;
    for (const Array3& x : relaxed) sum += std::polar(1.0, 2 * M_PI * x[axis]);
    EXPECT_LT(std::norm(sum), 0.1 * std::pow(double(relaxed.size()), 2)) << axis;
  }
}

// 32 x 16 is one tile, here with a spacing of 1/16; it is cached where the environment says.
TEST(GlassRelaxation, FillsBlocks) {
  const TemporaryFolder folder;
  const char* before = std::getenv("XDG_CACHE_HOME");
  const std::string kept = before ? before : "";
  setenv("XDG_CACHE_HOME", folder.path().c_str(), 1);
  const Block block{.dimension = 2, .counts = {32, 16, 1}, .lower = {-1, 0, 0}, .size = {2, 1, 1}};
  const auto x = arranged_points(block, "glass");
  if (before)
    setenv("XDG_CACHE_HOME", kept.c_str(), 1);
  else
    unsetenv("XDG_CACHE_HOME");
  ASSERT_EQ(x.size(), 512u);
  for (const Array3& p : x) EXPECT_TRUE(p[0] >= -1 && p[0] < 1 && p[1] >= 0 && p[1] < 1 && p[2] == 0);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "sphk" / "glass-2d-32x16-v2.bin"));
}

const std::vector<Array3> points{{0.25, 1.5, 0}, {1.75, 0.125, 0}, {0.5, 0.5, 0}, {1, 1, 0}};

TEST(GlassFile, NamesSayTheShape) {
  EXPECT_EQ(glass_file_name(3, {32, 16, 8}), "glass-3d-32x16x8-v2.bin");
  EXPECT_EQ(glass_file_name(2, {64, 32, 1}), "glass-2d-64x32-v2.bin");
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
