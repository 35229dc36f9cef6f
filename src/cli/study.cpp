// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "src/cli/commands.hpp"
#include "src/cli/options.hpp"
#include "src/engine/errors.hpp"
#include "src/engine/places.hpp"
#include "src/report/process.hpp"
#include "src/run/stop_signal.hpp"
#include "src/study/study_compare.hpp"

namespace sphk {

namespace {

/// Values with commas between them.
CLI::Option* lists(CLI::Option* option) {
  return option->delimiter(',')->type_name("A,B,...")->expected(1, 1000)->allow_extra_args(false);
}

/// An option whose values, with commas between them, are an axis of a study.
void axis(CLI::App& app, StudyRequest& study, const std::string& name, const std::string& key, const std::string& doc) {
  const auto take = [&study, key](const std::vector<std::string>& values) { study.axes.push_back({key, values}); };
  lists(app.add_option_function<std::vector<std::string>>(name, take, fmt::format("{} (key {})", doc, key)));
}

/// KEY=A,B,... as an axis.
StudyAxis axis_of(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos)
    throw InputError(fmt::format("--vary {}: write KEY=A,B,..., such as viscosity.alpha=0.5,1", text));
  StudyAxis axis{text.substr(0, equals), {}};
  std::string value;
  for (std::istringstream values(text.substr(equals + 1)); std::getline(values, value, ',');)
    axis.values.push_back(value);
  return axis;
}

std::string preset_lines() {
  std::string text;
  for (const StudyPlan& preset : study_files_in(shared_folder() / "studies"))
    text += fmt::format("  {:<20} {}\n", preset.name, preset.summary);
  return text;
}

void add_axes(CLI::App& app, StudyRequest& study) {
  axis(app, study, "--scheme", "sph.scheme", "schemes");
  axis(app, study, "--kernel", "sph.kernel", "smoothing kernels");
  axis(app, study, "--neighbours", "sph.neighbours", "neighbour numbers");
  axis(app, study, "--precision", "sph.precision", "pair arithmetic");
  axis(app, study, "--cfl", "time.courant", "Courant numbers");
  axis(app, study, "-n,--resolution", resolution_key, "resolutions");
  const auto take = [&study](const std::vector<std::string>& texts) {
    std::ranges::transform(texts, std::back_inserter(study.axes), axis_of);
  };
  repeats(app.add_option_function<std::vector<std::string>>("--vary", take, "any other key and its values"),
          "KEY=A,B,...");
}

void add_options(CLI::App& app, Options& o) {
  StudyRequest& study = o.study;
  app.add_option("what", o.names,
                 "a scene with an exact solution or converged runs, a study file (*.toml), a preset, or: compare STUDY "
                 "STUDY")
      ->required()
      ->expected(1, 3);
  add_axes(app, study);
  add_sets(app, o, "set a key of all runs");
  app.add_option("--repeat", study.repeat, "runs of each point; the fastest counts")->check(CLI::Range(1, 1000));
  app.add_option("--norm", study.norm, "the quantity whose error counts: v, rho, P, or a measure; default: v")
      ->type_name("FIELD");
  app.add_option("--target", study.target, "an error: how long until it is reached?")->check(CLI::PositiveNumber);
  lists(app.add_option("--budget", study.budgets, "CPU seconds: which method is best with them?"))
      ->check(CLI::PositiveNumber);
  app.add_option("--others", study.others, "points of other engines, as CSV: engine,setting,error,cpu_seconds,machine")
      ->type_name("FILE.csv");
  app.add_option("--max-time", study.max_seconds, "start no run after so many seconds")->check(CLI::PositiveNumber);
  add_threads(app, study.threads);
  add_path(app, "--out", study.out,
           "folder of the study; default: SCENE-study. What it holds already is not run again");
  add_path(app, "--report", study.report, "also write the study as one HTML page with everything in it")
      ->type_name("FILE.html");
  app.footer(
      "Examples:\n  sphk study sod -n 32,64,128 --scheme gadget2,sphs --repeat 3 --target 0.04\n"
      "  sphk study kernel-choice --report kernels.html\n  sphk study my_study.toml --max-time 600\n"
      "  sphk study compare before after/study.json\n\nPresets:\n" +
      preset_lines() +
      "\nA study file has the lines scene = \"sod\", norm, target, budgets, repeat, others as wanted, and the "
      "sections\n"
      "[set] (keys of all runs), [vary] (lists of values) and [[methods]]; the presets are such files, in "
      "share/sphk/studies.\n"
      "The folder gets study.json (every run, raw), study.csv, study.png, and each run's files under points/.");
}

/// Two studies, point by point: ratios of errors and CPU seconds, and what got worse.
int compare(const std::filesystem::path& before, const std::filesystem::path& after, const std::string& norm) {
  const StudyComparison comparison = compare_studies(before, after, norm);
  fmt::print("before: {}\nafter:  {}\n\n", comparison.before, comparison.after);
  fmt::print("  {:<40} {:>6} {:>12} {:>12}\n", "method", "n", "error ratio", "CPU ratio");
  for (const ComparedPoint& point : comparison.points)
    fmt::print("  {:<40} {:>6} {:>12.3f} {:>12.3f}  {}\n", point.method, point.n, point.error, point.cpu,
               point.verdict);
  fmt::print("\n{} points compared, {} of them worse: an error larger by 2 %, or 15 % more CPU time\n",
             comparison.points.size(), std::ranges::count_if(comparison.points, [](const ComparedPoint& point) {
               return !point.verdict.empty();
             }));
  return ExitCode::done;
}

}  // namespace

void add_study(CLI::App& root, Options& o) {
  CLI::App& app = *root.add_subcommand("study", "error against run time, over every combination of what is listed");
  add_options(app, o);
  acts(app, o, [&o] {
    const auto& what = o.names;
    if (what[0] == "compare" && what.size() == 3) return compare(what[1], what[2], o.study.norm);
    if (what[0] == "compare" || what.size() > 1)
      throw InputError("sphk study takes one scene, study file or preset, or the word compare and two studies");
    for (const Override& fixed : overrides(o)) o.study.fixed.emplace_back(fixed.name, fixed.text);
    o.study.what = what[0];
    study(o.study);
    return stop_requested() ? ExitCode::stopped : ExitCode::done;
  });
}

}  // namespace sphk
