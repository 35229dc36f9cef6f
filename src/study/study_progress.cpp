// SPDX-License-Identifier: BSD-3-Clause
#include "src/study/study_progress.hpp"
#include "src/report/print.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "src/report/quantity.hpp"

namespace sphk {

StudyProgress::StudyProgress(std::size_t points, const std::map<std::string, double>& expected)
    : points_(points), expected_(expected), terminal_(isatty(STDOUT_FILENO)) {
  for (const auto& [name, seconds] : expected_) total_ += seconds;
}

/// By the pace so far, once there is one.
double StudyProgress::seconds_left(double share) const {
  const double done = before_ + share * now_, left = total_ - done;
  return done > 0.02 * total_ ? left * all_.wall() / done : left;
}

void StudyProgress::begin(std::size_t index, const StudyPoint& point) {
  const auto expected = expected_.find(point.name());
  now_ = expected == expected_.end() ? 0 : expected->second;
  label_ = fmt::format("[{}/{}] {}", index + 1, points_, point.method());
  if (const std::string n = point.value(resolution_key); !n.empty()) label_ += " n = " + n;
  current_ = Stopwatch();
  if (terminal_) show(0);
}

void StudyProgress::show(double share) {
  if (!terminal_) return;
  say("\r\033[K{}: {:.0f} %, study about {} left", label_, 100 * share, duration_text(seconds_left(share)));
}

void StudyProgress::end(const std::string& result) {
  before_ += now_;
  now_ = 0;
  const double left = seconds_left(0);
  say("{}{}: {}, {}{}\n", terminal_ ? "\r\033[K" : "", label_, result, duration_text(current_.wall()),
      before_ < total_ ? fmt::format(", study about {} left", duration_text(std::max(left, 0.0))) : "");
}

}  // namespace sphk
