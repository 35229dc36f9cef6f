// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "src/study/plan.hpp"
#include "src/study/results.hpp"

namespace sphk {

/// A study on disk, study.json: what all its runs share, and every run's run.json by the name of its point.
struct StudyRecord {
  std::filesystem::path file;
  nlohmann::ordered_json json;

  bool has(const StudyPoint& point) const { return json["points"].contains(point.name()); }
  /// What the runs of a point that it has came to, by the norm of that field; `measured`: by what they measured at
  /// their end under that name, whether or not anything says what it should be.
  StudyResult result(const StudyPoint& point, const std::string& norm, bool measured = false) const;
  void save() const;
};

/// The record in this folder, or a new one. Throws InputError where it is of another scene or of other --set keys.
StudyRecord open_record(const StudyPlan& plan, const std::filesystem::path& folder);

/// The record in that file, or in that folder; throws InputError where there is none.
StudyRecord read_record(const std::filesystem::path& path);

nlohmann::ordered_json read_json(const std::filesystem::path& path);

/// A number of run.json, which has null in place of NaN and infinity: NaN then.
double number_in(const nlohmann::ordered_json& value);

}  // namespace sphk
