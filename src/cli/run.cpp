// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/run.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "src/cli/commands.hpp"
#include "src/cli/options.hpp"
#include "src/engine/errors.hpp"
#include "src/report/final_table.hpp"
#include "src/report/print.hpp"
#include "src/report/process.hpp"
#include "src/run/dry_run.hpp"

namespace sphk {

namespace {

std::string closing_words(const RunResult& result) {
  const std::string folder = result.folder.string();
  if (result.record.finished)
    return fmt::format("{} is complete; see it with: {} plot {}", folder, command_name(), folder);
  return fmt::format("stopped at t = {:.6g}, after step {}; go on with: {} run --resume {}", result.record.time,
                     result.record.steps, command_name(), folder);
}

/// The last line of a JSON log.
std::string closing_object(const RunResult& result) {
  using Json = nlohmann::ordered_json;
  return Json{
      {"message", closing_words(result)}, {"finished", result.record.finished}, {"folder", result.folder.string()}}
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

int run_command(const RunOptions& options) {
  if (options.dry_run) {
    const DryRun told = dry_run(problem_of(options.request));
    fmt::print("{}", options.json_log ? told.json() + "\n" : told.text());
    return ExitCode::done;
  }
  RunRequest request = options.request;
  request.progress = options.json_log ? ProgressStyle::json : style_for(stdout);
  request.stop_on_signals = true;
  if (request.walltime > 0) request.walltime = std::max(1e-9, request.walltime - age_of_this_process());
  std::signal(SIGPIPE, SIG_IGN);  // whoever read what a run prints may go before its end
  const RunResult result = run(request);
  if (options.json_log)
    print_if_possible(stdout, closing_object(result) + "\n");
  else
    print_if_possible(stdout, fmt::format("\n{}\n{}\n", final_table(result.record), closing_words(result)));
  return result.record.finished ? ExitCode::done : ExitCode::stopped;
}

/// 90, 1:30 or 0:01:30 in seconds.
double seconds_of(const std::string& text) {
  double seconds = 0;
  int count = 0;
  std::istringstream parts(text + ":");
  for (std::string part; std::getline(parts, part, ':'); ++count) {
    char* end = nullptr;
    const double value = std::strtod(part.c_str(), &end);
    if (part.empty() || *end != '\0' || !(value >= 0) || !std::isfinite(value) || count == 3)
      throw InputError(fmt::format("--walltime {}: write seconds, M:S or H:M:S", text));
    seconds = 60 * seconds + value;
  }
  if (!(seconds > 0)) throw InputError(fmt::format("--walltime {}: a positive time is wanted", text));
  return seconds;
}

}  // namespace

void add_run(CLI::App& root, Options& o) {
  CLI::App& app = *root.add_subcommand("run", "run a scene, a scene file or an initial condition");
  RunRequest& request = o.run.request;
  CLI::Option* what =
      app.add_option("what", request.what, "a scene (`sphk list`), a scene file (*.toml) or an HDF5 initial condition");
  add_path(app, "--resume", request.resume, "go on with the run in this folder, from its newest checkpoint")
      ->type_name("DIR")
      ->excludes(what);
  add_physics(app, o);
  shortcut(app, o, "-n,--resolution", "scene.n", "N", "the scene's resolution, particles along the box (key scene.n)");
  shortcut(app, o, "--t-end", "time.end", "T", "end time in code units (key time.end)");
  shortcut(app, o, "--steps", "time.max_steps", "N", "stop after so many steps (key time.max_steps)");
  add_threads(app, o.threads);
  add_path(app, "--out", request.out,
           "folder of the results; default: SCENE-run, or SCENE-run-2, ... where that exists");
  app.add_option_function<std::string>(
         "--walltime", [&request](const std::string& text) { request.walltime = seconds_of(text); },
         "stop with a checkpoint before so much wall-clock time of this process is over: seconds, M:S or H:M:S")
      ->type_name("TIME");
  app.add_option("--watch", request.watch,
                 "draw the run as it is, as watch.png in its folder, every so many seconds of wall-clock time")
      ->check(CLI::PositiveNumber)
      ->type_name("SECONDS");
  app.add_flag("--overwrite", request.overwrite, "replace the run that the folder of --out holds");
  app.add_flag("--dry-run", o.run.dry_run, "tell memory, steps, output size and run time from a trial of three steps");
  app.add_flag("--json-log", o.run.json_log, "print one JSON object a line instead of text");
  app.footer(
      "Examples:\n  sphk run sod\n  sphk run gresho -n 64 --neighbours 128 --kernel hoct4\n"
      "  sphk run sedov --set scene.lattice=cubic --t-end 0.05 --out blast\n  sphk run my.toml --dry-run\n"
      "  sphk run galaxy.hdf5 --t-end 0.2\n\n"
      "The folder gets snapshots (snap_0000.hdf5, ...), history.csv, run.json and scene.used.toml.\n"
      "SIGTERM, SIGINT, SIGUSR1, SIGHUP, SIGXCPU, a file named stop in the run's folder and --walltime end the step, "
      "leave a\ncheckpoint and exit with 75; SIGUSR2 leaves a checkpoint and goes on. `sphk run --resume DIR` "
      "continues bit by bit, on as\nmany threads. A run goes on in silence where nobody reads what it prints: its "
      "results are in its folder, which\nbelongs to it (run.lock) until its end.\n"
      "Exit codes: 0 done, 2 bad input, 3 numerics, 4 device or memory, 75 stopped with a checkpoint.");
  computes(app, o, [&o, &request] {
    if (request.what.empty() && !request.resume) throw InputError("sphk run takes a scene or file, or --resume DIR");
    if (request.resume && (!o.shortcuts.empty() || !o.sets.empty() || request.out))
      throw InputError(
          "--resume goes on with the run as it is: of the other options only --threads, --walltime, --watch and "
          "--json-log go with it");
    request.overrides = overrides(o);
    return run_command(o.run);
  });
}

}  // namespace sphk
