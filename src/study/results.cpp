// SPDX-License-Identifier: BSD-3-Clause
#include "src/study/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "src/report/quantity.hpp"

namespace sphk {

namespace {

/// Results by rising cost and falling error: those that no other beats in both, and that have logarithms.
std::vector<StudyResult> worth_their_cost(const std::vector<StudyResult>& results) {
  std::vector<StudyResult> runs;
  std::ranges::copy_if(results, std::back_inserter(runs),
                       [&](const StudyResult& r) { return on_front(r, results) && r.error > 0 && r.cpu > 0; });
  std::ranges::sort(runs, {}, &StudyResult::cpu);
  return runs;
}

/// Results with an error and a resolution, the coarsest first.
std::vector<StudyResult> by_resolution(const std::vector<StudyResult>& results) {
  std::vector<StudyResult> runs;
  std::ranges::copy_if(results, std::back_inserter(runs),
                       [](const StudyResult& r) { return r.valid() && r.error > 0 && r.n > 0; });
  std::ranges::sort(runs, {}, &StudyResult::n);
  return runs;
}

/// y between (x1, y1) and (x2, y2), or beyond, on a straight line of logarithms.
double on_power_law(double x, double x1, double y1, double x2, double y2) {
  return y1 * std::pow(y2 / y1, std::log(x / x1) / std::log(x2 / x1));
}

}  // namespace

bool any_joules(const std::vector<StudyResult>& results) {
  return std::ranges::any_of(results, [](const StudyResult& r) { return r.joules.has_value(); });
}

std::optional<double> fitted_order(const std::vector<StudyResult>& of_one_method) {
  const std::vector<StudyResult> results = by_resolution(of_one_method);
  const auto falls = [](const StudyResult& coarse, const StudyResult& fine) { return fine.error < coarse.error; };
  if (std::ranges::adjacent_find(results, std::not_fn(falls)) != results.end()) return std::nullopt;
  double count = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const StudyResult& r : results) {
    const double a = std::log(r.n), b = std::log(r.error);
    count += 1, x += a, y += b, xx += a * a, xy += a * b;
  }
  const double spread = count * xx - x * x;
  if (count < 2 || !(spread > 1e-12)) return std::nullopt;
  return -(count * xy - x * y) / spread;
}

std::vector<CostRatio> cost_ratios(const std::vector<StudyResult>& results) {
  const auto groups = by_method(results);
  const auto at = [](const std::vector<StudyResult>& group, double n) {
    return std::ranges::find_if(group, [n](const StudyResult& r) { return r.n == n && r.cpu > 0 && r.updates > 0; });
  };
  const StudyResult* reference = nullptr;
  std::ptrdiff_t most = 1;
  for (const StudyResult& r : groups.empty() ? std::vector<StudyResult>{} : by_resolution(groups[0])) {
    const auto there = std::ranges::count_if(groups, [&](const auto& group) { return at(group, r.n) != group.end(); });
    if (there > 1 && there >= most) most = there, reference = &*at(groups[0], r.n);
  }
  std::vector<CostRatio> ratios;
  if (!reference) return ratios;
  for (const auto& group : groups)
    if (const auto r = at(group, reference->n); r != group.end())
      ratios.push_back({.method = r->point.method(),
                        .n = r->n,
                        .microseconds = 1e6 * r->cpu / r->updates,
                        .update = r->cpu / r->updates / (reference->cpu / reference->updates),
                        .run = r->cpu / reference->cpu});
  return ratios;
}

TimeToTarget time_to_target(const std::vector<StudyResult>& results, double target) {
  const std::vector<StudyResult> runs = worth_their_cost(results);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (runs[k].error > target) continue;
    if (k == 0) return {TimeToTarget::How::at_once, runs[0].cpu};
    const StudyResult &worse = runs[k - 1], &better = runs[k];
    return {TimeToTarget::How::interpolated, on_power_law(target, worse.error, worse.cpu, better.error, better.cpu)};
  }
  return {};
}

std::optional<Expectation> error_within(const std::vector<StudyResult>& results, double cpu) {
  constexpr double farthest = 60;
  const std::vector<StudyResult> runs = worth_their_cost(results);
  if (runs.empty() || cpu < runs.front().cpu) return std::nullopt;
  const StudyResult& dearest = runs.back();
  Expectation expectation{dearest.point.method(), dearest.error, dearest.n, cpu > dearest.cpu};
  if (runs.size() < 2 || cpu == dearest.cpu) return cpu == dearest.cpu ? std::optional(expectation) : std::nullopt;
  if (cpu > farthest * dearest.cpu) return std::nullopt;
  const auto next = std::ranges::upper_bound(runs, cpu, {}, &StudyResult::cpu);
  const StudyResult& b = next == runs.end() ? dearest : *next;
  const StudyResult& a = next == runs.end() ? runs[runs.size() - 2] : *(next - 1);
  expectation.error = on_power_law(cpu, a.cpu, a.error, b.cpu, b.error);
  if (a.n > 0 && b.n > 0) expectation.n = on_power_law(cpu, a.cpu, a.n, b.cpu, b.n);
  return expectation;
}

std::optional<Expectation> best_within(const std::vector<StudyResult>& results, double cpu) {
  std::optional<Expectation> best;
  double best_share = 0;
  for (const auto& group : by_method(results)) {
    const auto expectation = error_within(group, cpu);
    if (!expectation) continue;
    const double share = std::min(group.back().cpu / cpu, 0.5);  // of the budget that has been tried
    const bool better = !best || (share == best_share ? expectation->error < best->error : share > best_share);
    if (better) best = expectation, best_share = share;
  }
  return best;
}

std::vector<std::vector<StudyResult>> by_method(const std::vector<StudyResult>& results) {
  std::vector<std::vector<StudyResult>> groups;
  for (const StudyResult& r : results) {
    if (!r.valid()) continue;
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

bool on_front(const StudyResult& r, const std::vector<StudyResult>& results) {
  return r.valid() && std::ranges::none_of(results, [&](const StudyResult& other) {
           return other.valid() && other.error <= r.error && other.cpu <= r.cpu &&
                  (other.error < r.error || other.cpu < r.cpu);
         });
}

Table study_table(const std::vector<StudyResult>& results, const std::string& quantity, bool ranked) {
  std::vector<StudyResult> rows = results;
  std::ranges::stable_sort(rows, [](const StudyResult& a, const StudyResult& b) {
    return a.valid() != b.valid() ? a.valid() : a.valid() && a.cpu < b.cpu;
  });
  Table table{{"method", "n", "particles", quantity, "dE/E", "steps", "wall s", "CPU s", "updates/s", "memory", "best"},
              {}};
  if (any_joules(rows)) table.head.insert(table.head.end() - 1, "uJ/update");
  for (const StudyResult& r : rows) {
    std::vector<std::string> row{r.point.method(), r.point.value(resolution_key)};
    if (r.valid())
      row = {r.point.method(),
             fmt::format("{:g}", r.n),
             fmt::format("{:g}", r.particles),
             fmt::format("{:.4g}", r.error),
             fmt::format("{:.1e}", r.energy_drift),
             fmt::format("{:g}", r.steps),
             fmt::format("{:.3g}", r.wall),
             fmt::format("{:.3g}", r.cpu),
             with_prefix(r.wall > 0 ? r.updates / r.wall : 0),
             bytes_text(r.bytes)};
    row.resize(table.head.size(), "-");
    if (r.valid() && r.joules) row[row.size() - 2] = fmt::format("{:.3g}", 1e6 * *r.joules / r.updates);
    row.back() = !r.valid() ? "failed" : ranked && on_front(r, rows) ? "*" : "";
    table.rows.push_back(row);
  }
  return table;
}

Table order_table(const std::vector<StudyResult>& results) {
  Table table{{"method", "order of convergence in n"}, {}};
  for (const auto& group : by_method(results))
    if (by_resolution(group).size() > 1) {
      const auto order = fitted_order(group);
      table.rows.push_back({group[0].point.method(), order ? fmt::format("{:.2f}", *order) : "its errors do not fall"});
    }
  return table;
}

Table cost_table(const std::vector<StudyResult>& results) {
  Table table{{"method", "n", "CPU us/update", "over the first", "whole run over the first"}, {}};
  for (const CostRatio& r : cost_ratios(results))
    table.rows.push_back({r.method, fmt::format("{:g}", r.n), fmt::format("{:.3g}", r.microseconds),
                          fmt::format("{:.2f}", r.update), fmt::format("{:.2f}", r.run)});
  return table;
}

Table target_table(const std::vector<StudyResult>& results, double target) {
  Table table{{"method", fmt::format("CPU s to an error of {:g}", target)}, {}};
  for (const auto& group : by_method(results)) {
    const TimeToTarget time = time_to_target(group, target);
    table.rows.push_back({group[0].point.method(), time.how == TimeToTarget::How::not_reached ? "not reached"
                                                   : time.how == TimeToTarget::How::at_once
                                                       ? fmt::format("below {:.3g}", time.cpu)
                                                       : fmt::format("{:.3g}", time.cpu)});
  }
  return table;
}

Table budget_table(const std::vector<StudyResult>& results, const std::vector<double>& budgets) {
  Table table{{"CPU time", "best method", "n", "error"}, {}, {0, 1}};
  for (const double budget : budgets) {
    const auto best = best_within(results, budget);
    if (best)
      table.rows.push_back({duration_text(budget), best->method, fmt::format("{:.0f}", best->n),
                            fmt::format("{:.3g}{}", best->error, best->extrapolated ? " (extrapolated)" : "")});
    else
      table.rows.push_back({duration_text(budget), "no run comes near", "-", "-"});
  }
  return table;
}

Table others_table(const std::vector<StudyResult>& results, const std::vector<OtherPoint>& others) {
  Table table{{"other engine", "error", "CPU s there", "CPU s here", "ratio", "method here"}, {}, {0, 5}};
  for (const OtherPoint& other : others) {
    std::optional<TimeToTarget> best;
    std::string method;
    for (const auto& group : by_method(results)) {
      const TimeToTarget time = time_to_target(group, other.error);
      if (time.how == TimeToTarget::How::not_reached || (best && best->cpu <= time.cpu)) continue;
      best = time;
      method = group[0].point.method();
    }
    std::vector<std::string> row{other.engine + ", " + other.setting,
                                 fmt::format("{:.3g}", other.error),
                                 fmt::format("{:.3g}", other.cpu),
                                 "not reached",
                                 "",
                                 ""};
    if (best) {
      const double ratio = other.cpu / best->cpu;
      const bool below = best->how == TimeToTarget::How::at_once;  // the cheapest run is better already
      row[3] = fmt::format("{}{:.3g}", below ? "below " : "", best->cpu);
      row[4] = fmt::format("{}{:.{}f}", below ? "over " : "", ratio, ratio < 10 ? 1 : 0);
      row[5] = method;
    }
    table.rows.push_back(row);
  }
  return table;
}

}  // namespace sphk
