// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/readers_box.hpp"

#include <algorithm>
#include <cmath>

namespace sphk {

namespace {

struct Extent {
  double low, high;
};

/// Of the supports of all particles along an axis, and of the run's box.
Extent held(const Snapshot& snapshot, std::size_t axis) {
  Extent all{snapshot.box.lower[axis], snapshot.box.lower[axis] + snapshot.box.size[axis]};
  const std::vector<double>& x = snapshot.field("Coordinates").values;
  const bool has_supports = snapshot.has("SmoothingLength");
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    const double h = has_supports ? snapshot.field("SmoothingLength").values[i] : 0;
    all.low = std::min(all.low, x[3 * i + axis] - h);
    all.high = std::max(all.high, x[3 * i + axis] + h);
  }
  return all;
}

/// The width of what the gas does not fill: no support reaches over half of it.
double depth(const Snapshot& snapshot, const Array3& size) {
  double depth = *std::max_element(size.begin(), size.begin() + snapshot.dimension);
  if (snapshot.has("SmoothingLength"))
    for (const double h : snapshot.field("SmoothingLength").values) depth = std::max(depth, 2 * h);
  return depth;
}

Array3 three(const hdf5::Group& group, const char* name, double missing) {
  const auto numbers = group.numbers_or(name, {});
  if (numbers.size() != 3) return {missing, missing, missing};
  return {numbers[0], numbers[1], numbers[2]};
}

std::array<bool, 3> flags(const Array3& numbers) {
  return {numbers[0] != 0, numbers[1] != 0, numbers[2] != 0};
}

/// Those of true_points(), where there are any of the same rows.
std::vector<double> points_of(const hdf5::File& file, std::size_t rows) {
  if (!file.has("VTKHDF") || !file.group("VTKHDF").has("Points")) return {};
  const hdf5::Dataset points = file.group("VTKHDF").dataset("Points");
  if (points.shape() != std::vector<hsize_t>{rows, 3}) return {};
  return points.read<double>();
}

}  // namespace

Array3 ReadersBox::placed(const Array3& x) const {
  Array3 y = x;
  for (std::size_t k = 0; k < 3; ++k) {
    y[k] += shift[k];
    if (wraps[k]) y[k] -= size[k] * std::floor(y[k] / size[k]);
    if (y[k] >= size[k] && (wraps[k] || shift[k] != 0)) y[k] = std::nextafter(size[k], 0.0);  // by rounding
  }
  return y;
}

ReadersBox unshifted_box(const Snapshot& snapshot) {
  return {.size = snapshot.box.size, .periodic = std::ranges::count(snapshot.box.periodic, true) > 0};
}

ReadersBox readers_box(const Snapshot& snapshot) {
  ReadersBox box = unshifted_box(snapshot);
  box.wraps = snapshot.box.periodic;
  const auto dimension = static_cast<std::size_t>(snapshot.dimension);
  for (std::size_t k = 0; k < dimension; ++k) {
    const Extent all =
        box.wraps[k] ? Extent{snapshot.box.lower[k], snapshot.box.lower[k] + box.size[k]} : held(snapshot, k);
    box.shift[k] = 0 - all.low;
    if (!box.wraps[k]) box.size[k] = all.high - all.low;
  }
  const double across = depth(snapshot, box.size);
  for (std::size_t k = dimension; k < 3; ++k) box.size[k] = across, box.shift[k] = across / 2;
  return box;
}

std::vector<double> true_points(const Snapshot& snapshot, const ReadersBox& box) {
  const std::vector<double>& x = snapshot.field("Coordinates").values;
  const auto dimension = static_cast<std::size_t>(snapshot.dimension);
  std::vector<double> points;
  for (std::size_t i = 0; i < x.size(); i += 3) {
    const Array3 seen = box.placed({x[i], x[i + 1], x[i + 2]});
    if (points.empty() && !std::equal(&x[i], &x[i] + dimension, seen.begin())) points = x;
  }
  for (std::size_t i = 0; i < points.size(); i += 3) {
    const Array3 seen = box.placed({x[i], x[i + 1], x[i + 2]});
    std::copy(seen.begin() + dimension, seen.end(), &points[i] + dimension);
  }
  return points;
}

void undo_shift(const hdf5::File& file, std::span<Array3> x) {
  if (!file.has("sphk")) return;
  const hdf5::Group own = file.group("sphk"), header = file.group("Header");
  const auto dimension = static_cast<std::size_t>(own.number_or("Dimension", 3));
  const ReadersBox box{.size = three(header, "BoxSize", 1),
                       .shift = three(header, "Shift", 0),
                       .wraps = flags(three(own, "Periodic", 0))};
  const std::vector<double> points = points_of(file, x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    Array3 kept{};
    for (std::size_t k = 0; k < std::min<std::size_t>(dimension, points.empty() ? 0 : 3); ++k)
      kept[k] = points[3 * i + k];
    const bool as_written = !points.empty() && box.placed(kept) == x[i];
    for (std::size_t k = 0; k < 3; ++k) x[i][k] = as_written ? kept[k] : x[i][k] - box.shift[k];
  }
}

}  // namespace sphk
