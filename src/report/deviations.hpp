// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/report/history.hpp"
#include "src/scenes/scene.hpp"

namespace sphk {

/// How far a run's measure is from converged runs.
struct Deviation {
  struct At {
    double time = 0, value = 0, low = 0, high = 0;
  };
  std::vector<At> at;       ///< the times that the run reached
  bool over_start = false;  ///< the values are those of the measure over its value at the start
  /// Distances from [low, high], their sum over that of the middles.
  double l1() const;
};

/// Compares the measures of a run with a scene's references while it goes on.
class Deviations {
 public:
  explicit Deviations(std::vector<Reference> references) : references_(std::move(references)) {}

  /// Times after `begin`, up to `end`, at which add() is wanted; rising.
  std::vector<double> times(double begin, double end) const;
  /// The measures at the start or at one of the times, within a millionth of it.
  void add(double time, const History::Measures& measures);
  const std::map<std::string, Deviation>& by_measure() const { return by_measure_; }

 private:
  std::vector<Reference> references_;
  std::map<std::string, double> start_;
  std::map<std::string, Deviation> by_measure_;
};

}  // namespace sphk
