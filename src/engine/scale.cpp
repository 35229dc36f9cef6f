// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/scale.hpp"

#include <algorithm>
#include <cmath>

namespace sphk {

namespace {

/// The binary logarithm of x, rounded down; 0 of what has none.
int exponent_of(double x) {
  return x > 0 && std::isfinite(x) ? std::ilogb(x) : 0;
}

double quantile(std::vector<double>& values, double share) {
  const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + k, values.end());
  return values[static_cast<std::size_t>(k)];
}

/// Half of the particles lie that close along the axis on which they stray most; outliers do not count. Where half are
/// at one place all of them do, where all are their box.
double width(const ParticleSet& particles) {
  double widest = 0, extent = 0, box = 0;
  std::vector<double> x(particles.size());
  for (std::size_t d = 0; d < static_cast<std::size_t>(particles.dimension); ++d) {
    std::ranges::transform(particles.x, x.begin(), [d](const Array3& place) { return place[d]; });
    const double from = quantile(x, 0.25);
    widest = std::max(widest, quantile(x, 0.75) - from);
    const auto [first, last] = std::ranges::minmax(x);
    extent = std::max(extent, last - first);
    box = std::max(box, particles.box.size[d]);
  }
  return widest > 0 ? widest : extent > 0 ? extent : box;
}

/// Mean square of the velocities against their mean, and mean specific energy: of each particle the larger.
double mean_square_speed(const ParticleSet& particles) {
  const double n = static_cast<double>(particles.size());
  Array3 mean{};
  for (const Array3& v : particles.v)
    for (std::size_t d = 0; d < 3; ++d) mean[d] += v[d] / n;
  double sum = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    double v2 = 0;
    for (std::size_t d = 0; d < 3; ++d) v2 += (particles.v[i][d] - mean[d]) * (particles.v[i][d] - mean[d]);
    sum += std::max(v2, particles.u[i]) / n;
  }
  return sum;
}

}  // namespace

double Scale::factor(const UnitExponents& unit) const {
  return std::exp2(length * unit.length + mass * unit.mass + time * unit.time);
}

Scale scale_of(const ParticleSet& particles) {
  if (particles.size() == 0) return {};
  std::vector<double> m = particles.m;
  const double particles_across = std::pow(static_cast<double>(particles.size()), 1.0 / particles.dimension);
  Scale scale;
  scale.length = exponent_of(width(particles)) - std::ilogb(particles_across);
  scale.mass = exponent_of(quantile(m, 0.5));
  scale.time = scale.length - static_cast<int>(std::floor(exponent_of(mean_square_speed(particles)) / 2.0));
  return scale;
}

}  // namespace sphk
