#include "src/scenes/glass_relaxation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "kernels/smoothing/cubic_spline.hpp"
#include "src/scenes/glass.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

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
  const Counts counts{side, side, 1};
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
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "sphk" / "glass-2d-32x16-v1.bin"));
}

}  // namespace
}  // namespace sphk
