// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <string>

#include "src/engine/simulation.hpp"
#include "src/report/machine.hpp"

namespace sphk {

/// How a run tells where it is: a bar redrawn in place on a terminal, plain lines or JSON objects elsewhere; or not
/// at all.
enum class ProgressStyle { bar, lines, json, none };

/// Prints time, dt, step, updates/s, neighbours, energy drift, time left and the particle that limits dt.
class Progress {
 public:
  struct Span {
    double from = 0, to = 1;  ///< times of the run, code units
    long steps = 0;           ///< limit of steps; 0: none
  };

  Progress(ProgressStyle style, Span span, std::FILE* out = stdout);
  /// Ends an unfinished bar.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Is it time for the next report? Every 0.2 s (bar) or 5 s, and at the first step.
  bool due() const;
  /// Nothing where the step has been told. `updates`: particles updated since the start; `energy_drift`: relative. The
  /// rates are those since the last report.
  void report(const StepReport& step, long updates, double energy_drift);
  /// A line of its own between the reports.
  void say(const std::string& line);

 private:
  struct Speed {
    double updates_per_second = 0, seconds_left = 0;
  };
  Speed speed(const StepReport& step, long updates) const;
  void print_bar(const StepReport& step, const Speed& speed, double energy_drift);
  void print_line(const StepReport& step, const Speed& speed, double energy_drift) const;
  void print_json(const StepReport& step, const Speed& speed, double energy_drift) const;
  /// Part of the run that is done, 0 to 1.
  double done(const StepReport& step) const;

  ProgressStyle style_;
  Span span_;
  std::FILE* out_;
  Stopwatch watch_;
  double last_wall_ = 0, last_time_ = 0;
  long last_step_ = 0, last_updates_ = 0;
  bool started_ = false, open_bar_ = false;
};

/// A bar where `out` is a terminal, lines elsewhere.
ProgressStyle style_for(std::FILE* out);

}  // namespace sphk
