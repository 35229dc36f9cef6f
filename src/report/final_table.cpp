// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/final_table.hpp"

#include <fmt/format.h>

#include <iterator>

#include "src/report/quantity.hpp"

namespace sphk {

namespace {

using Text = std::back_insert_iterator<std::string>;

void phase_row(Text out, const std::string& name, double seconds, const RunRecord& r) {
  const double updates = static_cast<double>(r.costs.updates);
  const double share = r.wall_seconds > 0 ? 100 * seconds / r.wall_seconds : 0;
  fmt::format_to(out, "  {:<30} {:>9.3f} {:>6.1f} {:>12.3f}\n", name, seconds, share,
                 updates > 0 ? 1e6 * seconds / updates : 0);
}

void phases(Text out, const RunRecord& r) {
  fmt::format_to(out, "  {:<30} {:>9} {:>6} {:>12}\n", "phase", "seconds", "%", "us/update");
  double listed = 0;
  for (const auto& [name, seconds] : r.costs.phases) {
    phase_row(out, name, seconds, r);
    listed += seconds;
  }
  if (r.wall_seconds > listed) phase_row(out, "other", r.wall_seconds - listed, r);
  phase_row(out, "time loop", r.wall_seconds, r);
  fmt::format_to(out, "  set-up {}, output {}, CPU of the time loop {}\n", duration_text(r.setup_seconds),
                 duration_text(r.output_seconds), duration_text(r.cpu_seconds));
  if (r.joules)
    fmt::format_to(out, "  energy of the processors {:.4g} J, {:.3g} uJ per update\n", *r.joules,
                   r.costs.updates > 0 ? 1e6 * *r.joules / static_cast<double>(r.costs.updates) : 0);
}

void rates(Text out, const RunRecord& r) {
  fmt::format_to(out, "  {} steps, {} updates: {} updates/s, {} pairs/s\n", r.steps,
                 with_prefix(static_cast<double>(r.costs.updates)), with_prefix(r.updates_per_second()),
                 with_prefix(r.pairs_per_second()));
  fmt::format_to(out, "  {}FLOP/s, {:.1f} % of the measured FMA peak of {}FLOP/s\n", with_prefix(r.flops_per_second()),
                 100 * r.share_of_peak(), with_prefix(r.platform.fma_peak));
  fmt::format_to(out, "  peak memory {}, {:.0f} bytes per particle on the device\n", bytes_text(r.peak_memory_bytes),
                 r.costs.bytes_per_particle);
}

void physics(Text out, const RunRecord& r) {
  const Conservation& c = r.conservation;
  fmt::format_to(out, "  relative drift: energy {:.2e}, momentum {:.2e}, angular momentum {:.2e}, mass {:.2e}\n",
                 c.energy, c.momentum, c.angular_momentum, c.mass);
  for (const auto& [field, norm] : r.errors)
    fmt::format_to(out, "  error of {:<16} L1 {:<10.4g} L2 {:<10.4g} Linf {:<10.4g} at ({:.4g}, {:.4g}, {:.4g})\n",
                   field, norm.l1, norm.l2, norm.linf, norm.where[0], norm.where[1], norm.where[2]);
  for (const auto& [measure, deviation] : r.deviations) {
    std::vector<std::string> found;
    for (const Deviation::At& a : deviation.at)
      found.push_back(a.low == a.high ? fmt::format("{:.3g} of {:.3g}", a.value, a.low)
                                      : fmt::format("{:.3g} of {:.3g} to {:.3g}", a.value, a.low, a.high));
    fmt::format_to(out, "  {:<25} L1 {:<10.4g} of converged runs: {}\n",
                   measure + (deviation.over_start ? " over its start" : ""), deviation.l1(), fmt::join(found, ", "));
  }
}

void error_budget(Text out, const ErrorBudget& b) {
  const auto row = [&](const char* name, const ErrorShare& share) {
    fmt::format_to(out, "  {:<30} {:>9} {:>10.3g} {:>10.3g} {:>10.3g}\n", name, share.particles, share.mean, share.high,
                   share.max);
  };
  fmt::format_to(out, "  {:<30} {:>9} {:>10} {:>10} {:>10}\n", "|E0| (R10 eq 28)", "particles", "mean", "95 %", "max");
  row("all", b.all);
  row("where fluids meet", b.boundary);
  row("away from there", b.bulk);
  fmt::format_to(
      out,
      "  mean |R - 1| {:.3g}, |V - 1| {:.3g}, |epsilon| {:.3g} of |rho div v|; nearest neighbour at {:.3g} mean "
      "spacings, 5 % below {:.3g}\n",
      b.R, b.V, b.epsilon, b.nearest, b.nearest_low);
}

}  // namespace

std::string final_table(const RunRecord& record) {
  std::string text;
  const Text out(text);
  phases(out, record);
  rates(out, record);
  physics(out, record);
  if (record.budget) error_budget(out, *record.budget);
  for (const auto& warning : record.warnings) fmt::format_to(out, "  note: {}\n", warning);
  return text;
}

}  // namespace sphk
