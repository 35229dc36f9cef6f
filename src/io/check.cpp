// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "src/engine/errors.hpp"

namespace sphk {

namespace {

constexpr std::size_t max_examples = 3;
using Severity = Finding::Severity;

bool finite(const Array3& a) {
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}

void require_size(const char* name, std::size_t size, std::size_t n, bool may_be_empty) {
  if (size != n && !(may_be_empty && size == 0))
    throw InputError(fmt::format("the particle set has {} rows of {} and {} of x; they must agree", size, name, n));
}

/// Appends a finding with the rows for which `wrong` holds, in the order given; nothing when there are none.
class Collector {
 public:
  explicit Collector(const ParticleSet& particles) : p_(particles) {}

  void rows(Severity severity, const char* problem, auto wrong) {
    Finding finding{severity, problem, 0, {}};
    for (std::size_t i = 0; i < p_.size(); ++i)
      if (wrong(i)) add(finding, i);
    keep(std::move(finding));
  }

  /// Rows that equal an earlier one: `order` is sorted so that equals are neighbours.
  void repeats(Severity severity, const char* problem, const std::vector<std::size_t>& order, auto equal) {
    Finding finding{severity, problem, 0, {}};
    for (std::size_t k = 1; k < order.size(); ++k)
      if (equal(order[k - 1], order[k])) add(finding, order[k]);
    keep(std::move(finding));
  }

  std::vector<Finding> findings() && { return std::move(findings_); }

 private:
  void add(Finding& finding, std::size_t i) {
    if (finding.count++ < max_examples) finding.examples.push_back({i, p_.id.empty() ? i + 1 : p_.id[i], p_.x[i]});
  }
  void keep(Finding finding) {
    if (finding.count > 0) findings_.push_back(std::move(finding));
  }

  const ParticleSet& p_;
  std::vector<Finding> findings_;
};

/// Rows 0..n-1 sorted by `key`; equal rows stay in the file's order.
std::vector<std::size_t> sorted_rows(std::size_t n, auto key) {
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::ranges::less{}, key);
  return order;
}

/// Positions with periodic axes brought into the box, so that both ends of it are one place; infinity, which no two
/// particles are said to share, where they are not finite.
std::vector<Array3> wrapped(const ParticleSet& p) {
  std::vector<Array3> x = p.x;
  for (Array3& position : x) {
    for (std::size_t k = 0; k < 3; ++k)
      if (p.box.periodic[k]) position[k] -= p.box.size[k] * std::floor((position[k] - p.box.lower[k]) / p.box.size[k]);
    if (!finite(position)) position.fill(std::numeric_limits<double>::infinity());  // NaN has no place in an order
  }
  return x;
}

/// Whether it is more than `lengths` of the box beyond an end of it; along periodic axes only, where those count.
bool outside(const ParticleSet& p, std::size_t i, double lengths, bool periodic_only) {
  for (std::size_t k = 0; k < static_cast<std::size_t>(p.dimension); ++k) {
    const double lower = p.box.lower[k], size = p.box.size[k], margin = lengths * size;
    if (periodic_only && !p.box.periodic[k]) continue;
    if (p.x[i][k] < lower - margin || p.x[i][k] > lower + size + margin) return true;
  }
  return false;
}

/// A few particles may have left a periodic box and be wrapped into it; many that are far out have another unit.
void find_outside(Collector& collect, const ParticleSet& p) {
  constexpr std::size_t many = 50;  // one in so many
  const auto far = [&](std::size_t i) { return outside(p, i, 1, true); };
  std::size_t count = 0;
  for (std::size_t i = 0; i < p.size(); ++i) count += far(i);
  if (count * many > p.size())
    collect.rows(Severity::error,
                 "more than a box length outside the periodic box (BoxSize must be in the unit of Coordinates)", far);
  else
    collect.rows(Severity::notice, "outside the box", [&](std::size_t i) { return outside(p, i, 0, false); });
}

}  // namespace

std::vector<Finding> check_particles(const ParticleSet& p) {
  const std::size_t n = p.size();
  require_size("v", p.v.size(), n, false);
  require_size("m", p.m.size(), n, false);
  require_size("u", p.u.size(), n, false);
  require_size("h", p.h.size(), n, true);
  require_size("id", p.id.size(), n, true);

  Collector collect(p);
  collect.rows(Severity::error, "with NaN or infinite values", [&](std::size_t i) {
    return !finite(p.x[i]) || !finite(p.v[i]) || !std::isfinite(p.m[i]) || !std::isfinite(p.u[i]) ||
           (!p.h.empty() && !std::isfinite(p.h[i]));
  });
  collect.rows(Severity::error, "with zero or negative mass", [&](std::size_t i) { return p.m[i] <= 0; });
  collect.rows(Severity::error, "with negative specific thermal energy", [&](std::size_t i) { return p.u[i] < 0; });
  if (!p.h.empty())
    collect.rows(Severity::error, "with negative smoothing length", [&](std::size_t i) { return p.h[i] < 0; });
  if (!p.id.empty())
    collect.repeats(Severity::error, "with the id of another one",
                    sorted_rows(n, [&](std::size_t i) { return p.id[i]; }),
                    [&](std::size_t a, std::size_t b) { return p.id[a] == p.id[b]; });
  const std::vector<Array3> x = wrapped(p);
  collect.repeats(Severity::notice, "at exactly the place of another one",
                  sorted_rows(n, [&](std::size_t i) { return x[i]; }),
                  [&](std::size_t a, std::size_t b) { return finite(x[a]) && x[a] == x[b]; });
  find_outside(collect, p);
  return std::move(collect).findings();
}

std::string to_text(const Finding& finding) {
  std::string text = fmt::format("{} particle{} {}: ", finding.count, finding.count == 1 ? "" : "s", finding.problem);
  for (const auto& [index, id, x] : finding.examples)
    text += fmt::format("{}row {} (id {}) at ({:.6g}, {:.6g}, {:.6g})",
                        &index == &finding.examples[0].index ? "" : "; ", index, id, x[0], x[1], x[2]);
  return finding.count > finding.examples.size() ? text + "; ..." : text;
}

std::string dimension_in_doubt(const ReadResult& content) {
  const ParticleSet& gas = content.particles;
  if (content.dimension_said || gas.size() < 2) return "";
  const auto same = [&](std::size_t k) {
    return std::ranges::all_of(gas.x, [&](const Array3& x) { return x[k] == gas.x[0][k]; });
  };
  const auto dimension = static_cast<std::size_t>(gas.dimension);
  std::vector<char> flat;
  for (std::size_t k = 0; k < dimension; ++k)
    if (same(k)) flat.push_back("xyz"[k]);
  if (flat.empty() || flat.size() == dimension) return "";
  const auto meant = dimension - flat.size();
  const bool last = flat[0] == "xyz"[meant];
  return fmt::format(
      "all particles have the same {}: say whether the gas is {}D or a sheet in {}D, by scene.dimension={} or {}, or "
      "by "
      "the attribute Dimension of Header{}",
      fmt::join(flat, " and "), meant, dimension, meant, dimension,
      last ? "" : fmt::format("; gas of {}D lies along {}", meant, meant == 1 ? "x" : "x and y"));
}

Verdict judge(const ReadResult& content) {
  Verdict verdict{content.remarks, {}};
  if (content.particles.size() == 0) verdict.errors.emplace_back("it holds no gas particles: at least one is needed");
  for (const Finding& finding : check_particles(content.particles))
    (finding.severity == Severity::error ? verdict.errors : verdict.notes).push_back(to_text(finding));
  return verdict;
}

}  // namespace sphk
