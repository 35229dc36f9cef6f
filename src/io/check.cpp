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

bool outside(const Box& box, int dimension, const Array3& x) {
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
    if (x[k] < box.lower[k] || x[k] > box.lower[k] + box.size[k]) return true;
  return false;
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
  collect.rows(Severity::notice, "outside the box", [&](std::size_t i) { return outside(p.box, p.dimension, p.x[i]); });
  return std::move(collect).findings();
}

std::string to_text(const Finding& finding) {
  std::string text = fmt::format("{} particle{} {}: ", finding.count, finding.count == 1 ? "" : "s", finding.problem);
  for (const auto& [index, id, x] : finding.examples)
    text += fmt::format("{}row {} (id {}) at ({:.6g}, {:.6g}, {:.6g})",
                        &index == &finding.examples[0].index ? "" : "; ", index, id, x[0], x[1], x[2]);
  return finding.count > finding.examples.size() ? text + "; ..." : text;
}

}  // namespace sphk
