#include <fmt/format.h>

#include "src/cli/commands.hpp"
#include "src/cli/study_record.hpp"

namespace sphk {

namespace {

constexpr double worse_error = 1.02, slower = 1.15;  // what counts as a regression: beyond the noise of timings

StudyPoint point_of(const nlohmann::ordered_json& entry) {
  StudyPoint point;
  for (const auto& [key, value] : entry["keys"].items()) point.keys.emplace_back(key, value.get<std::string>());
  return point;
}

}  // namespace

int study_compare_command(const std::filesystem::path& before, const std::filesystem::path& after,
                          const std::string& norm) {
  const StudyRecord old_record = read_record(before), new_record = read_record(after);
  const std::string field = norm.empty() ? old_record.json.value("norm", "v") : norm;
  int compared = 0, regressions = 0;
  fmt::print("before: {}, {}\nafter:  {}, {}\n\n", old_record.file.string(), old_record.json["machine"].dump(),
             new_record.file.string(), new_record.json["machine"].dump());
  fmt::print("  {:<40} {:>6} {:>12} {:>12}\n", "method", "n", "error ratio", "CPU ratio");
  for (const auto& [name, entry] : old_record.json["points"].items()) {
    const StudyPoint point = point_of(entry);
    if (!new_record.has(point)) continue;
    const StudyResult a = result_of(point, entry, field), b = result_of(point, new_record.json["points"][name], field);
    if (!a.failure.empty()) continue;
    ++compared;
    const double error = b.error / a.error, cpu = b.cpu / a.cpu;
    const std::string verdict = !b.failure.empty()    ? "fails now: " + b.failure
                                : error > worse_error ? "larger error"
                                : cpu > slower        ? "slower"
                                                      : "";
    regressions += !verdict.empty();
    fmt::print("  {:<40} {:>6} {:>12.3f} {:>12.3f}  {}\n", point.method(), point.value(resolution_key), error, cpu,
               verdict);
  }
  fmt::print("\n{} points compared, {} of them worse: an error larger by 2 %, or 15 % more CPU time\n", compared,
             regressions);
  return ExitCode::done;
}

}  // namespace sphk
