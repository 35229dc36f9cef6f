// SPDX-License-Identifier: BSD-3-Clause
#include "src/study/study_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "src/engine/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/input_file.hpp"
#include "src/report/machine.hpp"
#include "src/run/platform.hpp"

namespace sphk {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;

Json read_json(const fs::path& path) {
  std::ifstream file(path);
  return Json::parse(file, nullptr, false);
}

double number_in(const Json& value) {
  return value.is_null() ? std::nan("") : value.get<double>();
}

void StudyRecord::save() const {
  write_atomically(file, json.dump(1) + "\n");
}

StudyRecord open_record(const StudyPlan& plan, const fs::path& folder) {
  Json fixed = Json::object();
  for (const auto& [key, value] : plan.fixed) fixed[key] = value;
  StudyRecord record{folder / "study.json", {}};
  if (fs::exists(record.file)) {
    record = read_record(record.file);
    if (record.json["scene"] != plan.scene || record.json["fixed"] != fixed)
      throw InputError(fmt::format("{} holds a study of {} with the keys {}: name another folder with --out",
                                   record.file.string(), record.json["scene"].dump(), record.json["fixed"].dump()));
    return record;
  }
  record.json = {{"scene", plan.scene},
                 {"fixed", fixed},
                 {"machine", machine_name()},
                 {"version", build().version},
                 {"git_revision", build().git_revision},
                 {"compiler", build().compiler},
                 {"points", Json::object()}};
  return record;
}

StudyRecord read_record(const fs::path& path) {
  StudyRecord record{fs::is_directory(path) ? path / "study.json" : path, {}};
  if (fs::exists(record.file)) require_file(record.file);
  record.json = read_json(record.file);
  if (record.json.is_discarded() || !record.json.contains("points") || !record.json.contains("fixed"))
    throw InputError(
        fmt::format("{} is no study: give a folder that `sphk study` made, or its study.json", record.file.string()));
  return record;
}

StudyResult StudyRecord::result(const StudyPoint& point, const std::string& norm, bool measured) const {
  const Json& entry = json["points"][point.name()];
  StudyResult r;
  r.point = point;
  r.failure = entry.value("failure", "");
  if (!r.failure.empty()) {
    std::istringstream(point.value(resolution_key)) >> r.n;
    r.wall = r.cpu = entry.value("spent_seconds", 0.0);
    return r;
  }
  const Json& first = entry["runs"][0];
  r.n = first["n"], r.particles = first["particles"], r.steps = first["steps"];
  r.updates = first["updates"], r.pairs = first["pair_interactions"], r.bytes = first["peak_memory_bytes"];
  r.energy_drift = number_in(first["conservation"]["energy"]);
  r.wall = r.cpu = 1e300;
  for (const Json& run : entry["runs"]) {
    r.wall = std::min<double>(r.wall, run["wall_seconds"]);
    r.cpu = std::min<double>(r.cpu, run["cpu_seconds"]);
    if (run.contains("joules") && run["joules"].is_number())
      r.joules = std::min<double>(r.joules.value_or(1e300), run["joules"]);
  }
  const auto take = [&](const Json& value) {
    r.error = number_in(value);
    if (!std::isfinite(r.error)) r.failure = fmt::format("the norm of \"{}\" is not finite", norm);
    return r;
  };
  for (const char* kind : {"errors", "deviations"})
    if (!measured && first.contains(kind) && first[kind].contains(norm)) return take(first[kind][norm]["l1"]);
  if (first.contains("measures") && first["measures"].contains(norm)) return take(first["measures"][norm]);
  r.failure = fmt::format("no norm of \"{}\"; choose another with --norm", norm);
  return r;
}

}  // namespace sphk
