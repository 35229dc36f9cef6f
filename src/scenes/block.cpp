// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/block.hpp"

#include <cmath>

#include "src/scenes/glass.hpp"
#include "src/scenes/random.hpp"

namespace sphk {

namespace {

/// Calls visit(i, j, k) for 0 <= i < counts[0] and so on, the last index fastest.
template <class F>
void for_each_cell(const GridCounts& counts, F&& visit) {
  for (int i = 0; i < counts[0]; ++i)
    for (int j = 0; j < counts[1]; ++j)
      for (int k = 0; k < counts[2]; ++k) visit(GridCounts{i, j, k});
}

/// The place of a point given in spacings from the block's lower corner.
Array3 in_block(const Block& block, const Array3& spacings) {
  Array3 x{};
  for (int axis = 0; axis < block.dimension; ++axis)
    x[axis] = block.lower[axis] + block.size[axis] * spacings[axis] / block.counts[axis];
  return x;
}

std::vector<Array3> glass_points(const Block& block) {
  const GridCounts tile = glass_tile(block.counts, block.dimension);
  const std::vector<Array3> points = glass(block.dimension, tile);
  const GridCounts tiles{block.counts[0] / tile[0], block.counts[1] / tile[1], block.counts[2] / tile[2]};
  std::vector<Array3> x;
  x.reserve(block.particles());
  for_each_cell(tiles, [&](const GridCounts& cell) {
    for (const Array3& p : points)
      x.push_back(in_block(block, {p[0] + cell[0] * tile[0], p[1] + cell[1] * tile[1], p[2] + cell[2] * tile[2]}));
  });
  return x;
}

std::vector<Array3> random_points(const Block& block, std::uint64_t seed) {
  Uniform uniform(seed);
  std::vector<Array3> x(block.particles());
  for (Array3& point : x)
    for (int axis = 0; axis < block.dimension; ++axis) point[axis] = block.lower[axis] + block.size[axis] * uniform();
  return x;
}

}  // namespace

GridCounts even_counts(int dimension, int n) {
  return {n, dimension > 1 ? n : 1, dimension > 2 ? n : 1};
}

Block centred_cube(int dimension, int n, double half) {
  Block block{.dimension = dimension, .counts = even_counts(dimension, n)};
  for (int axis = 0; axis < dimension; ++axis) block.lower[axis] = -half, block.size[axis] = 2 * half;
  return block;
}

Block bar(int dimension, int n, int across, double lower, double length) {
  Block block{dimension, even_counts(dimension, across), {lower, 0, 0}, {length, 1, 1}};
  block.counts[0] = static_cast<int>(std::lround(n * length));
  for (int axis = 1; axis < dimension; ++axis) block.size[axis] = double(across) / n;
  return block;
}

double wrapped(double x, double size) {
  const double inside = x - size * std::floor(x / size);
  return inside < size ? inside : 0;  // a tiny negative x rounds up to the far edge
}

std::vector<Array3> lattice_points(const Block& block) {
  std::vector<Array3> x;
  x.reserve(block.particles());
  for_each_cell(block.counts, [&](const GridCounts& cell) {
    x.push_back(in_block(block, {cell[0] + 0.5, cell[1] + 0.5, cell[2] + 0.5}));
  });
  return x;
}

std::vector<Array3> arranged_points(const Block& block, const std::string& arrangement, std::uint64_t seed) {
  if (arrangement == "random") return random_points(block, seed);
  return arrangement == "glass" && block.dimension > 1 ? glass_points(block) : lattice_points(block);
}

void add_block(ParticleSet& gas, const Block& block, const std::string& arrangement, double rho, std::uint64_t seed) {
  const std::vector<Array3> points = arranged_points(block, arrangement, seed);
  gas.x.insert(gas.x.end(), points.begin(), points.end());
  gas.v.resize(gas.size());
  gas.m.resize(gas.size(), rho * block.volume() / double(points.size()));
}

ParticleSet even_gas(const Block& block, const std::string& arrangement, std::uint64_t seed) {
  ParticleSet gas;
  gas.dimension = block.dimension;
  gas.box = {block.lower, block.size, {true, block.dimension > 1, block.dimension > 2}};
  add_block(gas, block, arrangement, 1, seed);
  return gas;
}

}  // namespace sphk
