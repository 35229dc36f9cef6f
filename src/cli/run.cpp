#include "src/run/run.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "src/cli/commands.hpp"
#include "src/report/final_table.hpp"
#include "src/run/dry_run.hpp"

namespace sphk {

namespace {

std::string closing_words(const RunResult& result) {
  const std::string folder = result.folder.string();
  if (result.record.finished) return fmt::format("{} is complete; see it with: sphk plot {}", folder, folder);
  return fmt::format("stopped at t = {:.6g}, after step {}; go on with: sphk run --resume {}", result.record.time,
                     result.record.steps, folder);
}

/// The last line of a JSON log.
std::string closing_object(const RunResult& result) {
  using Json = nlohmann::ordered_json;
  return Json{
      {"message", closing_words(result)}, {"finished", result.record.finished}, {"folder", result.folder.string()}}
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

int run_command(const RunOptions& options) {
  if (options.dry_run) {
    const DryRun told = dry_run(problem_of(options.request));
    fmt::print("{}", options.json_log ? told.json() + "\n" : told.text());
    return ExitCode::done;
  }
  RunRequest request = options.request;
  request.progress = options.json_log ? ProgressStyle::json : style_for(stdout);
  request.stop_on_signals = true;
  const RunResult result = run(request);
  if (options.json_log)
    fmt::print("{}\n", closing_object(result));
  else
    fmt::print("\n{}\n{}\n", final_table(result.record), closing_words(result));
  return result.record.finished ? ExitCode::done : ExitCode::stopped;
}

}  // namespace sphk
