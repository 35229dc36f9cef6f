#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/study/points.hpp"

namespace sphk {

/// What a point's runs came to. Seconds are the least of the repeats, of the time loop alone.
struct StudyResult {
  StudyPoint point;
  std::string failure;  ///< why there is no result; empty: there is one
  double n = 0, particles = 0, steps = 0;
  double error = 0;  ///< the study's norm
  double energy_drift = 0;
  double wall = 0, cpu = 0;
  double updates = 0, pairs = 0, bytes = 0;
};

/// Fitted order of convergence of one method: - d ln(error) / d ln(n) by least squares; nothing below two points.
std::optional<double> fitted_order(const std::vector<StudyResult>& of_one_method);

/// CPU seconds at which a method reaches an error, and how that is known.
struct TimeToTarget {
  enum class How { interpolated, at_once, not_reached } how = How::not_reached;
  double cpu = 0;  ///< at_once: of the cheapest run, which is better already
};

/// Between the cheapest run below the target and the next cheaper one, interpolated in log(error) and log(seconds).
TimeToTarget time_to_target(const std::vector<StudyResult>& of_one_method, double target);

/// Results without failure, by method, in the order of first appearance; each by rising cost.
std::vector<std::vector<StudyResult>> by_method(const std::vector<StudyResult>& results);

/// Which results no other beats both in error and in CPU seconds.
std::vector<bool> pareto_front(const std::vector<StudyResult>& results);

/// The table of a study, by rising cost; failures at its end.
std::string study_table(const std::vector<StudyResult>& results, const std::string& norm);
/// One line a method: when it reaches the target.
std::string target_lines(const std::vector<StudyResult>& results, double target);

}  // namespace sphk
