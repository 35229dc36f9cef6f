// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/deviations.hpp"

#include <algorithm>
#include <cmath>

namespace sphk {

double Deviation::l1() const {
  double distances = 0, middles = 0;
  for (const At& a : at) {
    distances += std::max({a.low - a.value, a.value - a.high, 0.0});
    middles += (a.low + a.high) / 2;
  }
  return distances / middles;
}

std::vector<double> Deviations::times(double begin, double end) const {
  std::vector<double> times;
  for (const Reference& r : references_)
    if (r.time > begin && r.time <= end) times.push_back(r.time);
  std::ranges::sort(times);
  // clang 14 does not compile std::ranges::unique
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

void Deviations::add(double time, const History::Measures& measures) {
  if (start_.empty()) start_.insert(measures.begin(), measures.end());
  for (const Reference& r : references_) {
    const auto measure = std::ranges::find(measures, r.measure, &History::Measures::value_type::first);
    if (measure == measures.end() || std::abs(time - r.time) > 1e-6 * r.time) continue;
    const double unit = r.over_start ? start_.at(r.measure) : 1;
    Deviation& deviation = by_measure_[r.measure];
    deviation.at.push_back({r.time, measure->second / unit, r.low, r.high});
    deviation.over_start = r.over_start;
  }
}

}  // namespace sphk
