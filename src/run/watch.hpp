// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>

#include "src/engine/simulation.hpp"
#include "src/report/machine.hpp"
#include "src/report/process.hpp"
#include "src/report/progress.hpp"
#include "src/run/run_output.hpp"

namespace sphk {

/// The pictures that it leaves: what `sphk plot` makes of a snapshot, a figure and for some scenes a map beside it.
inline constexpr std::array watch_pictures{"watch.png", "watch_map.png"};

/// A picture of a run as it is, OUT/watch.png, drawn anew every so many seconds of wall-clock time by a process beside
/// the run, which goes on meanwhile. It sees the state alone; where it cannot draw, a note says so, once.
class Watch {
 public:
  /// `output` and `progress` must outlive this. `map`: a map of the density in place of profiles.
  Watch(const RunOutput& output, Progress& progress, double seconds, bool map);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// After a step: takes what has been drawn, and draws the next picture where it is time.
  void look(const Simulation& simulation);
  /// Draws the last one, and waits for it.
  void finish(const Simulation& simulation);

 private:
  void draw(const Simulation& simulation);
  /// Of a process that has ended.
  void take();

  const RunOutput& output_;
  Progress& progress_;
  double seconds_;
  bool map_, fails_ = false;
  std::filesystem::path folder_;
  std::unique_ptr<Process> drawing_;
  Stopwatch clock_;
  double next_ = 0;
};

}  // namespace sphk
