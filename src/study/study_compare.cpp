// SPDX-License-Identifier: BSD-3-Clause
#include "src/study/study_compare.hpp"

#include <fmt/format.h>

#include "src/study/study_record.hpp"

namespace sphk {

namespace {

using Json = nlohmann::ordered_json;

constexpr double worse_error = 1.02, slower = 1.15;  // what counts as a regression: beyond the noise of timings

std::string file_and_machine(const StudyRecord& record) {
  return fmt::format("{}, {}", record.file.string(), record.json["machine"].dump());
}

}  // namespace

StudyComparison compare_studies(const std::filesystem::path& before, const std::filesystem::path& after,
                                const std::string& norm) {
  const StudyRecord old_record = read_record(before), new_record = read_record(after);
  const std::string field = norm.empty() ? old_record.json.value("norm", "v") : norm;
  StudyComparison comparison{file_and_machine(old_record), file_and_machine(new_record), {}};
  for (const Json& entry : old_record.json["points"]) {
    StudyPoint point;
    for (const auto& [key, value] : entry["keys"].items()) point.keys.emplace_back(key, value.get<std::string>());
    if (!old_record.has(point) || !new_record.has(point)) continue;
    const StudyResult a = old_record.result(point, field), b = new_record.result(point, field);
    if (!a.failure.empty()) continue;
    const double error = b.error / a.error, cpu = b.cpu / a.cpu;
    const std::string verdict = !b.failure.empty()    ? "fails now: " + b.failure
                                : error > worse_error ? "larger error"
                                : cpu > slower        ? "slower"
                                                      : "";
    comparison.points.push_back({point.method(), point.value(resolution_key), error, cpu, verdict});
  }
  return comparison;
}

}  // namespace sphk
