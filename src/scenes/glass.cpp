#include "src/scenes/glass.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "src/engine/errors.hpp"
#include "src/scenes/glass_file.hpp"
#include "src/scenes/glass_relaxation.hpp"
#include "src/scenes/random.hpp"

namespace sphk {

std::filesystem::path glass_cache() {
  const auto folder = [](const char* variable) -> std::filesystem::path {
    const char* value = std::getenv(variable);
    return value ? value : "";
  };
  if (const auto cache = folder("XDG_CACHE_HOME"); cache.is_absolute()) return cache / "sphk";
  if (const auto home = folder("HOME"); home.is_absolute()) return home / ".cache" / "sphk";
  return {};
}

std::vector<Array3> glass_start(int dimension, const Counts& counts) {
  Uniform uniform(20120501);
  const Array3 size{double(counts[0]), double(counts[1]), double(counts[2])};
  auto points = lattice_points({.dimension = dimension, .counts = counts, .size = size});
  for (Array3& x : points)
    for (int axis = 0; axis < dimension; ++axis) x[axis] += uniform() - 0.5;
  return points;
}

std::vector<Array3> glass(int dimension, const Counts& counts, const Relaxer& relax,
                          const std::filesystem::path& cache) {
  const auto file = cache.empty() ? cache : cache / glass_file_name(dimension, counts);
  if (auto points = read_glass(file, dimension, counts)) return *std::move(points);
  const Array3 size{double(counts[0]), double(counts[1]), double(counts[2])};
  auto points = relax(dimension, size, glass_start(dimension, counts));
  for (Array3& x : points)
    for (int axis = 0; axis < dimension; ++axis) x[axis] = wrapped(x[axis], size[axis]);
  if (!file.empty()) write_glass(file, dimension, counts, points);
  return points;
}

std::vector<Array3> glass(int dimension, const Counts& counts) {
  return glass(dimension, counts, relax_with_engine, glass_cache());
}

Counts glass_tile(const Counts& counts, int dimension) {
  constexpr int least = 8;
  const int most = dimension == 3 ? 32 : 64;
  Counts tile{1, 1, 1};
  for (int axis = 0; axis < dimension; ++axis) {
    for (int k = std::min(most, counts[axis]); tile[axis] == 1 && k > 1; --k)
      if (counts[axis] % k == 0) tile[axis] = k;
    if (tile[axis] < std::min(least, counts[axis]))
      throw InputError(
          fmt::format("a glass of {} x {} x {} particles: copies of a tile of {} to {} cannot make {}; "
                      "take multiples of 16, or scene.lattice = \"cubic\"",
                      counts[0], counts[1], counts[2], least, most, counts[axis]));
  }
  return tile;
}

}  // namespace sphk
