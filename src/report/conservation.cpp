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

}  // namespace

Conservation drift(const Totals& start, const Totals& now, const Box& box) {
  const double heat = now.heated - start.heated;
  const double p_scale = std::sqrt(2 * start.mass * (start.kinetic + start.thermal + heat));
  const double side = *std::ranges::max_element(box.size);
  return {
      .energy = relative(std::abs(now.energy() - heat - start.energy()), std::abs(start.energy() + heat)),
      .momentum = relative(distance(now.momentum, start.momentum), std::max(length(start.momentum), p_scale)),
      .angular_momentum = relative(distance(now.angular_momentum, start.angular_momentum),
                                   std::max(length(start.angular_momentum), p_scale * side)),
      .mass = relative(std::abs(now.mass - start.mass), start.mass),
  };
}

}  // namespace sphk
