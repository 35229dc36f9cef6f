// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "src/report/print.hpp"
#include "src/report/quantity.hpp"

namespace sphk {

namespace {

constexpr auto replace = nlohmann::json::error_handler_t::replace;  // of what is no UTF-8, such as a file's name

int columns(std::FILE* out) {
  winsize size{};
  return ioctl(fileno(out), TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

std::string neighbours(const StepReport& s) {
  return fmt::format("{:.0f}/{:.1f}/{:.0f}", s.min_neighbours, s.mean_neighbours, s.max_neighbours);
}

std::string limiter(const StepReport& s) {
  return fmt::format("#{} at ({:.4g}, {:.4g}, {:.4g})", s.limiting_id, s.limiting_x[0], s.limiting_x[1],
                     s.limiting_x[2]);
}

}  // namespace

ProgressStyle style_for(std::FILE* out) {
  return isatty(fileno(out)) ? ProgressStyle::bar : ProgressStyle::lines;
}

Progress::Progress(ProgressStyle style, Span span, std::FILE* out)
    : style_(style), span_(span), out_(out), last_time_(span.from) {}

Progress::~Progress() {
  if (open_bar_) print_if_possible(out_, "\n");
}

bool Progress::due() const {
  if (style_ == ProgressStyle::none) return false;
  return !started_ || watch_.wall() - last_wall_ >= (style_ == ProgressStyle::bar ? 0.2 : 5.0);
}

void Progress::report(const StepReport& step, long updates, double energy_drift) {
  if (style_ == ProgressStyle::none || (started_ && step.step == last_step_)) return;
  const Speed now = speed(step, updates);
  if (style_ == ProgressStyle::bar)
    print_bar(step, now, energy_drift);
  else if (style_ == ProgressStyle::json)
    print_json(step, now, energy_drift);
  else
    print_line(step, now, energy_drift);
  std::fflush(out_);
  started_ = true;
  last_wall_ = watch_.wall();
  last_time_ = step.time;
  last_step_ = step.step;
  last_updates_ = updates;
}

void Progress::say(const std::string& line) {
  if (style_ == ProgressStyle::none) return;
  if (style_ == ProgressStyle::json)
    return print_if_possible(out_, nlohmann::json{{"message", line}}.dump(-1, ' ', false, replace) + "\n");
  print_if_possible(out_, (open_bar_ ? "\n" : "") + line + "\n");
  open_bar_ = false;
  std::fflush(out_);
}

double Progress::done(const StepReport& step) const {
  const double in_time = (step.time - span_.from) / std::max(span_.to - span_.from, 1e-300);
  const double in_steps = span_.steps > 0 ? static_cast<double>(step.step) / static_cast<double>(span_.steps) : 0;
  return std::clamp(std::max(in_time, in_steps), 0.0, 1.0);
}

Progress::Speed Progress::speed(const StepReport& step, long updates) const {
  const double wall = std::max(watch_.wall() - last_wall_, 1e-9);
  const double steps = static_cast<double>(std::max(step.step - last_step_, 1L));
  const double dt = (step.time - last_time_) / steps;
  double steps_left = dt > 0 ? (span_.to - step.time) / dt : 0;
  if (span_.steps > 0) steps_left = std::min(steps_left, static_cast<double>(span_.steps - step.step));
  return {static_cast<double>(updates - last_updates_) / wall, std::max(steps_left, 0.0) * wall / steps};
}

void Progress::print_bar(const StepReport& step, const Speed& speed, double energy_drift) {
  constexpr int width = 20;
  const double part = done(step);
  const int filled = static_cast<int>(part * width);
  std::string line = fmt::format("[{:#>{}}{:.>{}}] {:3.0f} %", "", filled, "", width - filled, 100 * part);
  const std::string parts[] = {fmt::format("{} left", duration_text(speed.seconds_left)),
                               fmt::format("t {:.4g}", step.time),
                               fmt::format("dt {:.2e}", step.dt),
                               fmt::format("step {}", step.step),
                               with_prefix(speed.updates_per_second) + " updates/s",
                               fmt::format("dE {:.1e}", energy_drift),
                               "neighbours " + neighbours(step),
                               "dt set by " + limiter(step)};
  for (const std::string& text : parts)  // as many as the terminal's line holds
    if (line.size() + 2 + text.size() < static_cast<std::size_t>(columns(out_))) line += "  " + text;
  print_if_possible(out_, "\r\033[K" + line);
  open_bar_ = true;
}

void Progress::print_line(const StepReport& step, const Speed& speed, double energy_drift) const {
  print_if_possible(
      out_,
      fmt::format("step {:6d}  t {:.6g} of {:.6g}  dt {:.3e}  {} updates/s  neighbours {}  energy drift {:.2e}  {} left"
                  "  dt set by {}\n",
                  step.step, step.time, span_.to, step.dt, with_prefix(speed.updates_per_second), neighbours(step),
                  energy_drift, duration_text(speed.seconds_left), limiter(step)));
}

void Progress::print_json(const StepReport& step, const Speed& speed, double energy_drift) const {
  const nlohmann::ordered_json json = {
      {"step", step.step},
      {"time", step.time},
      {"end", span_.to},
      {"dt", step.dt},
      {"updates_per_second", speed.updates_per_second},
      {"neighbours", {step.min_neighbours, step.mean_neighbours, step.max_neighbours}},
      {"energy_drift", energy_drift},
      {"seconds_left", speed.seconds_left},
      {"limiting_id", step.limiting_id},
      {"limiting_x", step.limiting_x},
  };
  print_if_possible(out_, json.dump() + "\n");
}

}  // namespace sphk
