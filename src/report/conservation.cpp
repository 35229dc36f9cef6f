// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/conservation.hpp"

#include <algorithm>
#include <cmath>

namespace sphk {

namespace {

double length(const Array3& a) {
  return std::hypot(a[0], a[1], a[2]);
}

double distance(const Array3& a, const Array3& b) {
  return length({a[0] - b[0], a[1] - b[1], a[2] - b[2]});
}

/// |difference| / scale; an empty or motionless system without a scale reports the difference itself.
double relative(double difference, double scale) {
  return scale > 0 ? difference / scale : difference;
}

/// |now - start| against |start|, where that is more than what sums of m |v| leave by rounding.
std::optional<double> of_start(const Array3& start, const Array3& now, double sizes) {
  const double scale = length(start);
  if (!(scale > 1e-10 * sizes)) return std::nullopt;
  return distance(now, start) / scale;
}

}  // namespace

Conservation drift(const Totals& start, const Totals& now, const Box& box) {
  const double heat = now.heated - start.heated;
  const double energy = start.kinetic + start.thermal + std::abs(start.potential) + heat;
  const double p_of_heat = 1e-6 * std::sqrt(2 * start.mass * (start.kinetic + start.thermal + heat));
  const double side = *std::ranges::max_element(box.size);
  const double p = std::max({start.momentum_sizes, now.momentum_sizes, p_of_heat});
  const double L = std::max({start.angular_momentum_sizes, now.angular_momentum_sizes, p_of_heat * side});
  return {
      .energy = relative(std::abs(now.energy() - heat - start.energy()), energy),
      .momentum = relative(distance(now.momentum, start.momentum), p),
      .angular_momentum = relative(distance(now.angular_momentum, start.angular_momentum), L),
      .mass = relative(std::abs(now.mass - start.mass), start.mass),
      .momentum_of_start = of_start(start.momentum, now.momentum, p),
      .angular_momentum_of_start = of_start(start.angular_momentum, now.angular_momentum, L),
  };
}

}  // namespace sphk
