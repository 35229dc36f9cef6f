// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/report/table.hpp"
#include "src/study/others.hpp"
#include "src/study/points.hpp"

namespace sphk {

/// What a point's runs came to. Seconds are the least of the repeats, of the time loop alone.
struct StudyResult {
  StudyPoint point;
  std::string failure;  ///< why there is no result; empty: there is one
  double n = 0, particles = 0, steps = 0;
  double error = 0;  ///< the study's norm
  double energy_drift = 0;
  double wall = 0, cpu = 0;  ///< of a failure: the wall-clock seconds until then, for both
  double updates = 0, pairs = 0, bytes = 0;
  std::optional<double> joules;  ///< the least of the repeats

  bool valid() const { return failure.empty(); }
};

/// Has a machine told the energy of any of these?
bool any_joules(const std::vector<StudyResult>& results);

/// Fitted order of convergence of one method: - d ln(error) / d ln(n) by least squares; nothing below two points, nor
/// where an error is not below that of the next coarser run.
std::optional<double> fitted_order(const std::vector<StudyResult>& of_one_method);

/// CPU seconds at which a method reaches an error, and how that is known.
struct TimeToTarget {
  enum class How { interpolated, at_once, not_reached } how = How::not_reached;
  double cpu = 0;  ///< at_once: of the cheapest run, which is better already
};

/// Between the cheapest run below the target and the next cheaper one, interpolated in log(error) and log(seconds).
TimeToTarget time_to_target(const std::vector<StudyResult>& of_one_method, double target);

/// The error that a method reaches in so many CPU seconds.
struct Expectation {
  std::string method;
  double error = 0;
  double n = 0;               ///< interpolated as well
  bool extrapolated = false;  ///< beyond the dearest run, along the last two
};

/// Interpolated in log(seconds) between a method's runs; beyond the dearest one by at most a factor 60. Nothing where
/// the method has no run so cheap.
std::optional<Expectation> error_within(const std::vector<StudyResult>& of_one_method, double cpu);
/// The method with the smallest such error, of those with a run of at least half that time; where there is none, of
/// those with the dearest runs: extrapolations flatter.
std::optional<Expectation> best_within(const std::vector<StudyResult>& results, double cpu);

/// CPU time of a method beside that of another.
struct CostRatio {
  std::string method;
  double n = 0;             ///< the resolution of both runs
  double microseconds = 0;  ///< CPU time of an update
  double update = 1;        ///< over that of the reference
  double run = 1;           ///< the whole time loop over that of the reference
};
/// Each method beside the first one, as S12 Fig. 11, at the largest resolution that most methods have in common with
/// it. Empty below two methods.
std::vector<CostRatio> cost_ratios(const std::vector<StudyResult>& results);

/// Results without failure, by method, in the order of first appearance; each by rising cost.
std::vector<std::vector<StudyResult>> by_method(const std::vector<StudyResult>& results);

/// Does no other of the results beat this one both in error and in CPU seconds?
bool on_front(const StudyResult& result, const std::vector<StudyResult>& results);

/// All results by rising cost, with the quantity that they are judged by; failures at the end. `ranked`: with a star at
/// those on the front.
Table study_table(const std::vector<StudyResult>& results, const std::string& quantity, bool ranked = true);
/// Fitted orders of the methods with several resolutions.
Table order_table(const std::vector<StudyResult>& results);
/// What an update of each method costs beside one of the first.
Table cost_table(const std::vector<StudyResult>& results);
/// When each method reaches the target.
Table target_table(const std::vector<StudyResult>& results, double target);
/// What is best for so many CPU seconds.
Table budget_table(const std::vector<StudyResult>& results, const std::vector<double>& budgets);
/// When the fastest method here reaches what others reach.
Table others_table(const std::vector<StudyResult>& results, const std::vector<OtherPoint>& others);

}  // namespace sphk
