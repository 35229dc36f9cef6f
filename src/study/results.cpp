#include "src/study/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/report/quantity.hpp"

namespace sphk {

namespace {

bool is_valid(const StudyResult& r) {
  return r.failure.empty();
}

}  // namespace

std::optional<double> fitted_order(const std::vector<StudyResult>& results) {
  double count = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const StudyResult& r : results) {
    if (!is_valid(r) || !(r.error > 0) || !(r.n > 0)) continue;
    const double a = std::log(r.n), b = std::log(r.error);
    count += 1, x += a, y += b, xx += a * a, xy += a * b;
  }
  const double spread = count * xx - x * x;
  if (count < 2 || !(spread > 1e-12)) return std::nullopt;
  return -(count * xy - x * y) / spread;
}

TimeToTarget time_to_target(const std::vector<StudyResult>& results, double target) {
  std::vector<StudyResult> runs;
  std::ranges::copy_if(results, std::back_inserter(runs),
                       [](const StudyResult& r) { return is_valid(r) && r.error > 0; });
  std::ranges::sort(runs, {}, &StudyResult::cpu);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (runs[k].error > target) continue;
    if (k == 0) return {TimeToTarget::How::at_once, runs[0].cpu};
    const StudyResult &worse = runs[k - 1], &better = runs[k];
    const double share = std::log(worse.error / target) / std::log(worse.error / better.error);
    return {TimeToTarget::How::interpolated, worse.cpu * std::pow(better.cpu / worse.cpu, share)};
  }
  return {};
}

std::vector<std::vector<StudyResult>> by_method(const std::vector<StudyResult>& results) {
  std::vector<std::vector<StudyResult>> groups;
  for (const StudyResult& r : results) {
    if (!is_valid(r)) continue;
    const auto group =
        std::ranges::find_if(groups, [&](const auto& g) { return g[0].point.method() == r.point.method(); });
    if (group == groups.end())
      groups.push_back({r});
    else
      group->push_back(r);
  }
  for (auto& group : groups) std::ranges::sort(group, {}, &StudyResult::cpu);
  return groups;
}

std::vector<bool> pareto_front(const std::vector<StudyResult>& results) {
  std::vector<bool> front;
  for (const StudyResult& r : results)
    front.push_back(is_valid(r) && std::ranges::none_of(results, [&](const StudyResult& other) {
                      return is_valid(other) && other.error <= r.error && other.cpu <= r.cpu &&
                             (other.error < r.error || other.cpu < r.cpu);
                    }));
  return front;
}

std::string study_table(const std::vector<StudyResult>& results, const std::string& norm) {
  std::vector<StudyResult> rows = results;
  std::ranges::stable_sort(rows, [](const StudyResult& a, const StudyResult& b) {
    return is_valid(a) != is_valid(b) ? is_valid(a) : a.cpu < b.cpu;
  });
  const std::vector<bool> front = pareto_front(rows);
  std::size_t width = 6;
  for (const StudyResult& r : rows) width = std::max(width, r.point.method().size());
  std::string text =
      fmt::format("  {:<{}} {:>6} {:>9} {:>10} {:>9} {:>7} {:>9} {:>9} {:>12} {:>10}\n", "method", width, "n",
                  "particles", "L1(" + norm + ")", "dE/E", "steps", "wall s", "CPU s", "updates/s", "memory");
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const StudyResult& r = rows[k];
    if (!is_valid(r)) {
      text +=
          fmt::format("  {:<{}} {:>6} failed: {}\n", r.point.method(), width, r.point.value(resolution_key), r.failure);
      continue;
    }
    text += fmt::format("  {:<{}} {:>6g} {:>9g} {:>10.4g} {:>9.1e} {:>7g} {:>9.3g} {:>9.3g} {:>12} {:>10}{}\n",
                        r.point.method(), width, r.n, r.particles, r.error, r.energy_drift, r.steps, r.wall, r.cpu,
                        with_prefix(r.wall > 0 ? r.updates / r.wall : 0), bytes_text(r.bytes), front[k] ? "  *" : "");
  }
  text += "  * no other run has a smaller error in less CPU time\n";
  for (const auto& group : by_method(results))
    if (const auto order = fitted_order(group))
      text += fmt::format("  {:<{}} order of convergence in n {:.2f}\n", group[0].point.method(), width, *order);
  return text;
}

std::string target_lines(const std::vector<StudyResult>& results, double target) {
  std::string text = fmt::format("CPU seconds to an error of {:g}:\n", target);
  for (const auto& group : by_method(results)) {
    const TimeToTarget time = time_to_target(group, target);
    const std::string what = time.how == TimeToTarget::How::not_reached ? "not reached"
                             : time.how == TimeToTarget::How::at_once   ? fmt::format("below {:.3g}", time.cpu)
                                                                        : fmt::format("{:.3g}", time.cpu);
    text += fmt::format("  {:<24} {}\n", group[0].point.method(), what);
  }
  return text;
}

}  // namespace sphk
