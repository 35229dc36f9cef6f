// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/smooth_layers.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "src/scenes/mass_profile.hpp"

namespace sphk {

double arctan_step(double distance, double width, double beta) {
  if (std::abs(distance) >= width / 2) return distance > 0 ? 1 : 0;
  return (1 + std::atan(2 * beta * distance / width) / std::atan(beta)) / 2;
}

std::vector<Array3> columns_of(const std::function<double(double)>& rho, Array3 lower, Array3 size, int along,
                               int rows) {
  const MassProfile profile(rho, lower[1], size[1]);
  std::vector<Array3> x;
  x.reserve(static_cast<std::size_t>(along) * static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row) {
    const double y = profile.place((row + 0.5) / rows);
    for (int k = 0; k < along; ++k) x.push_back({lower[0] + size[0] * (k + 0.5) / along, y, 0});
  }
  return x;
}

std::vector<Array3> rows_of(const std::function<double(double)>& rho, Array3 lower, Array3 size, double particles) {
  const MassProfile profile(rho, lower[1], size[1]);
  const double m = profile.mass() * size[0] / particles;
  // Particles of the rows from below, as long as half a row is left.
  std::vector<int> counts;
  for (double below = 0; below < 1;) {
    const auto count_at = [&](double fraction) {
      return std::max(1.0, std::round(size[0] * std::sqrt(rho(profile.place(std::clamp(fraction, 0.0, 1.0))) / m)));
    };
    const double thickness = count_at(below) / particles;  // of the row, as a fraction of the mass
    const double count = count_at(below + thickness / 2);
    if (1 - below < 0.5 * count / particles) break;
    counts.push_back(static_cast<int>(count));
    below += count / particles;
  }
  const double total = std::accumulate(counts.begin(), counts.end(), 0.0);
  std::vector<Array3> x;
  double below = 0;
  for (const int count : counts) {
    const double y = profile.place((below + count / 2.0) / total);
    for (int k = 0; k < count; ++k) x.push_back({lower[0] + size[0] * (k + 0.5) / count, y, 0});
    below += count;
  }
  return x;
}

}  // namespace sphk
