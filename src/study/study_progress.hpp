// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "src/report/machine.hpp"
#include "src/study/points.hpp"

namespace sphk {

/// Tells how far a study is: one line a point, rewritten in a terminal while the point runs.
class StudyProgress {
 public:
  /// `expected`: seconds of the points to run, by name; their sum need not be right, it is measured on the way.
  StudyProgress(std::size_t points, const std::map<std::string, double>& expected);

  void begin(std::size_t index, const StudyPoint& point);
  /// Share of the current point that is done.
  void show(double share);
  /// The point's last words.
  void end(const std::string& result);

 private:
  double seconds_left(double share) const;

  std::size_t points_;
  const std::map<std::string, double>& expected_;
  double before_ = 0, total_ = 0, now_ = 0;  ///< expected seconds of the points that are done, of all, of the current
  std::string label_;
  Stopwatch all_, current_;
  bool terminal_;
};

}  // namespace sphk
