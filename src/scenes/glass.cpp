// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/glass.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>

#include "src/engine/checksum.hpp"
#include "src/engine/errors.hpp"
#include "src/engine/places.hpp"
#include "src/scenes/random.hpp"
#include "src/scenes/scene.hpp"
#include "src/schemes/registry.hpp"

namespace sphk {

namespace {

/// Positions in a file: two bytes a coordinate, in parts of the box, so that a glass of 32^3 takes 197 kB. That moves
/// particles by less than a thousandth of their spacing, where densities of a glass scatter by half a per cent.
using Part = std::uint16_t;
constexpr double parts = 65536;

/// What a file begins with; the positions follow, a particle after the other.
struct Header {
  char magic[8] = {'s', 'p', 'h', 'k', 'g', 'l', 's', '3'};
  std::int64_t dimension = 0, counts[3] = {};
  std::uint64_t checksum = 0;  ///< of the positions
};

Header header_of(int dimension, const GridCounts& counts, const std::vector<Part>& points) {
  Header header;
  header.dimension = dimension;
  for (int axis = 0; axis < 3; ++axis) header.counts[axis] = counts[axis];
  Checksum sum;
  sum.add(points.data(), points.size() * sizeof(Part));
  header.checksum = sum.value();
  return header;
}

std::vector<Part> in_parts(int dimension, const GridCounts& counts, const std::vector<Array3>& points) {
  std::vector<Part> all;
  for (const Array3& x : points)
    for (int axis = 0; axis < dimension; ++axis)
      all.push_back(static_cast<Part>(std::llround(x[axis] / counts[axis] * parts)));  // the far edge is the near one
  return all;
}

std::vector<Array3> from_parts(int dimension, const GridCounts& counts, const std::vector<Part>& all) {
  std::vector<Array3> points(all.size() / static_cast<std::size_t>(dimension));
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::size_t axis = k % static_cast<std::size_t>(dimension);
    points[k / static_cast<std::size_t>(dimension)][axis] = all[k] / parts * counts[axis];
  }
  return points;
}

/// Root mean square of density / mean density - 1.
double scatter(const std::vector<double>& densities) {
  double sum = 0, squares = 0;
  for (const double rho : densities) sum += rho, squares += rho * rho;
  const double mean = sum / double(densities.size());
  return std::sqrt(std::max(squares / double(densities.size()) / (mean * mean) - 1, 0.0));
}

/// An isothermal gas: P ~ rho alike for all particles, although their entropies follow from the start's uneven density.
constexpr double nearly_one = 1 + 1e-6;

}  // namespace

std::filesystem::path glass_cache() {
  const auto folder = [](const char* variable) -> std::filesystem::path {
    const char* value = std::getenv(variable);
    return value ? value : "";
  };
  if (const auto cache = folder("XDG_CACHE_HOME"); cache.is_absolute()) return cache / "sphk";
  if (const auto home = folder("HOME"); home.is_absolute()) return home / ".cache" / "sphk";
  return {};
}

std::vector<Array3> glass_start(int dimension, const GridCounts& counts) {
  Uniform uniform(20120501);
  const Array3 size{double(counts[0]), double(counts[1]), double(counts[2])};
  auto points = lattice_points({.dimension = dimension, .counts = counts, .size = size});
  for (Array3& x : points)
    for (int axis = 0; axis < dimension; ++axis) x[axis] += uniform() - 0.5;
  return points;
}

std::vector<Array3> glass(int dimension, const GridCounts& counts, const Relaxer& relax,
                          const std::filesystem::path& cache) {
  const auto file = cache.empty() ? cache : cache / glass_file_name(dimension, counts);
  for (const std::filesystem::path& kept : {shared_folder() / "glasses" / glass_file_name(dimension, counts), file})
    if (auto points = read_glass(kept, dimension, counts)) return *std::move(points);
  const Array3 size{double(counts[0]), double(counts[1]), double(counts[2])};
  auto points = relax(dimension, size, glass_start(dimension, counts));
  for (Array3& x : points)
    for (int axis = 0; axis < dimension; ++axis) x[axis] = wrapped(x[axis], size[axis]);
  if (!file.empty()) write_glass(file, dimension, counts, points);
  return from_parts(dimension, counts, in_parts(dimension, counts, points));  // as they are read the next time
}

std::vector<Array3> glass(int dimension, const GridCounts& counts) {
  return glass(dimension, counts, relax_with_engine, glass_cache());
}

GridCounts glass_tile(const GridCounts& counts, int dimension) {
  constexpr int least = 8;
  const int most = dimension == 3 ? 32 : 64;
  GridCounts tile{1, 1, 1};
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

std::vector<Array3> relax_with_engine(int dimension, const Array3& size, std::vector<Array3> start) {
  ParticleSet gas;
  gas.dimension = dimension;
  for (int axis = 0; axis < dimension; ++axis) gas.box.size[axis] = size[axis], gas.box.periodic[axis] = true;
  gas.v.assign(start.size(), {});
  gas.m.assign(start.size(), 1);
  gas.u.assign(start.size(), 1 / (nearly_one - 1));
  gas.x = std::move(start);

  SimulationSettings settings;
  settings.scheme = "glass";
  settings.gamma = nearly_one;
  const auto simulation = make_simulation(gas, settings);

  constexpr int most_steps = 1000, steps_between_looks = 20;
  double before = std::numeric_limits<double>::infinity();
  for (int step = 1; step <= most_steps; ++step) {
    simulation->step(std::numeric_limits<double>::max());
    if (step % steps_between_looks != 0) continue;
    const double now = scatter(simulation->view().field("Densities").values);
    if (now > 0.98 * before) break;
    before = now;
  }
  const Snapshot settled = simulation->view();
  const auto x = rows(settled.field("Coordinates"));
  return {x.begin(), x.end()};
}

std::string glass_file_name(int dimension, const GridCounts& counts) {
  std::string name = fmt::format("glass-{}d-{}", dimension, counts[0]);
  for (int axis = 1; axis < dimension; ++axis) name += fmt::format("x{}", counts[axis]);
  return name + "-v2.bin";
}

std::optional<std::vector<Array3>> read_glass(const std::filesystem::path& file, int dimension,
                                              const GridCounts& counts) {
  std::ifstream in(file, std::ios::binary);
  Header header;
  std::vector<Part> points(static_cast<std::size_t>(dimension) *
                           Block{.dimension = dimension, .counts = counts}.particles());
  in.read(reinterpret_cast<char*>(&header), sizeof(header));
  in.read(reinterpret_cast<char*>(points.data()), static_cast<std::streamsize>(points.size() * sizeof(Part)));
  const Header wanted = header_of(dimension, counts, points);
  if (!in || in.peek() != EOF || std::memcmp(&header, &wanted, sizeof(header)) != 0) return std::nullopt;
  return from_parts(dimension, counts, points);
}

void write_glass(const std::filesystem::path& file, int dimension, const GridCounts& counts,
                 const std::vector<Array3>& points) {
  std::error_code failed;
  std::filesystem::create_directories(file.parent_path(), failed);
  const std::filesystem::path partial = file.string() + fmt::format(".{}", getpid());
  const std::vector<Part> rounded = in_parts(dimension, counts, points);
  const Header header = header_of(dimension, counts, rounded);
  std::ofstream out(partial, std::ios::binary);
  out.write(reinterpret_cast<const char*>(&header), sizeof(header));
  out.write(reinterpret_cast<const char*>(rounded.data()), static_cast<std::streamsize>(rounded.size() * sizeof(Part)));
  out.close();
  if (out)
    std::filesystem::rename(partial, file, failed);
  else
    std::filesystem::remove(partial, failed);
}

}  // namespace sphk
