// SPDX-License-Identifier: BSD-3-Clause
#include "src/study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "src/engine/errors.hpp"
#include "src/engine/places.hpp"
#include "src/io/atomic_file.hpp"
#include "src/report/history.hpp"
#include "src/report/machine.hpp"
#include "src/report/plot_script.hpp"
#include "src/report/print.hpp"
#include "src/report/process.hpp"
#include "src/report/quantity.hpp"
#include "src/run/failure.hpp"
#include "src/run/stop_signal.hpp"
#include "src/scenes/norms.hpp"
#include "src/study/child.hpp"
#include "src/study/others.hpp"
#include "src/study/study_progress.hpp"
#include "src/study/study_record.hpp"
#include "src/study/study_report.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

KeyTexts keys_of(const StudyPlan& plan, const StudyPoint& point) {
  KeyTexts keys = plan.fixed;
  std::ranges::copy(point.keys, std::back_inserter(keys));
  return keys;
}

void refuse_keys_given_twice(const StudyRequest& request) {
  std::vector<std::string> keys;
  for (const auto& [key, text] : request.fixed) keys.push_back(key);
  for (const StudyAxis& axis : request.axes) keys.push_back(axis.key);
  std::ranges::sort(keys);
  if (const auto twice = std::ranges::adjacent_find(keys); twice != keys.end())
    throw InputError(fmt::format("{} is given twice, by its own option, --vary or --set: give it once", *twice));
}

/// A preset's file, a study file, or the axes of the command line; with the request's own choices.
StudyPlan asked_plan(const StudyRequest& request) {
  const std::string& what = request.what;
  const fs::path preset = shared_folder() / "studies" / (what + ".toml");
  const bool named = what.find('/') == std::string::npos && fs::exists(preset);
  refuse_keys_given_twice(request);
  StudyPlan plan;
  if (named || is_study_file(what)) {
    plan = read_study_file(named ? preset : fs::path(what));
    if (!request.axes.empty())
      throw InputError(fmt::format("{} says itself what it runs; name its scene, {}, to choose on the command line",
                                   what, plan.scene));
  } else {
    plan.scene = what;
    plan.points = product_of(request.axes);
  }
  for (const auto& key : request.fixed) {
    std::erase_if(plan.fixed, [&](const auto& other) { return other.first == key.first; });
    plan.fixed.push_back(key);
  }
  if (!request.norm.empty()) plan.norm = request.norm;
  if (request.target > 0) plan.target = request.target;
  if (!request.budgets.empty()) plan.budgets = request.budgets;
  plan.repeat = request.repeat > 0 ? request.repeat : std::max(plan.repeat, 1);
  if (!request.others.empty()) plan.others = request.others;
  return plan;
}

[[noreturn]] void fail_without_error(const StudyPlan& plan, const Scene& scene) {
  const std::string wanted = scene.keys_with_references();
  throw InputError(fmt::format(
      "{} has neither an exact solution nor values of converged runs{}; --norm NAME takes a column of history.csv as "
      "it "
      "is at the end",
      plan.scene,
      wanted.empty() ? ", so there is no error to study" : " with these keys; it has them with --set " + wanted));
}

/// Throws InputError where a point's keys are none or nothing measures its error, before anything runs. Chooses the
/// norm where nobody did.
void check(StudyPlan& plan) {
  for (const StudyPoint& point : plan.points) {
    const Problem problem = resolve_problem(plan.scene, overrides_of(keys_of(plan, point)));
    const bool exact = bool(problem.scene->exact(problem.settings));
    if (exact && plan.norm.empty()) plan.norm = "v";
    if (exact && !meaning_of_error(plan.norm).empty()) continue;
    const std::vector<Reference> references = problem.scene->references(problem.settings);
    if (exact && references.empty())
      throw InputError(fmt::format(
          "{} has no error of \"{}\"; take --norm v, rho or P, against the exact solution at the centres of the bins "
          "with _centres behind it, of all particles with _particles",
          plan.scene, plan.norm));
    if (references.empty()) {
      if (plan.norm.empty()) fail_without_error(plan, *problem.scene);
      plan.measured = true;
      continue;
    }
    if (plan.norm.empty()) plan.norm = references[0].measure;
    if (std::ranges::find(references, plan.norm, &Reference::measure) == references.end())
      throw InputError(fmt::format("{} has no converged values of \"{}\"; take --norm {}", plan.scene, plan.norm,
                                   references[0].measure));
  }
}

/// A run's run.json, with what it measured at its end.
Json what_came_of(const fs::path& folder) {
  Json run = read_json(folder / "run.json");
  run["measures"] = read_history(folder / "history.csv").back();
  return run;
}

/// Throws InputError where a run did not measure what a study of a measure asks for.
void expect_measure(const StudyPlan& plan, const Json& runs) {
  if (!plan.measured || runs.empty() || runs[0]["measures"].contains(plan.norm)) return;
  std::vector<std::string> names;
  for (const auto& [name, value] : runs[0]["measures"].items()) names.push_back(name);
  throw InputError(
      fmt::format("{} measures no \"{}\"; take --norm with one of {}", plan.scene, plan.norm, fmt::join(names, ", ")));
}

class Study {
 public:
  Study(StudyPlan plan, const StudyRequest& request)
      : plan_(std::move(plan)),
        threads_(request.threads),
        folder_(
            request.out.value_or(plan_.name.empty() ? fs::path(plan_.scene).stem().string() + "-study" : plan_.name)) {
    fs::create_directories(folder_);
    record_ = open_record(plan_, folder_);
    record_.json["norm"] = plan_.norm;
  }

  /// Tells how many points are to run and about how long that takes.
  void announce() {
    double expected = 0;
    for (const StudyPoint& point : plan_.points) {
      if (record_.has(point) || stop_requested()) continue;
      expected_[point.name()] = plan_.repeat * trial(point);
      expected += expected_[point.name()];
    }
    say("{} points of {}, {} of them to run, {} in {}{}\n", plan_.points.size(), plan_.scene, expected_.size(),
        plan_.repeat == 1 ? "once each" : fmt::format("{} times each", plan_.repeat), folder_.string(),
        expected_.empty() ? "" : "; about " + duration_text(expected));
  }

  /// Runs what is not in the record, until so many seconds are over or a stop is asked for.
  void run(double max_seconds) {
    const Stopwatch watch;
    StudyProgress progress(plan_.points.size(), expected_);
    for (std::size_t k = 0; k < plan_.points.size(); ++k) {
      const StudyPoint& point = plan_.points[k];
      if (record_.has(point)) continue;
      if (max_seconds > 0 && watch.wall() > max_seconds) {
        say("--max-time {:g} s is over: the same command goes on with the rest\n", max_seconds);
        return;
      }
      progress.begin(k, point);
      run_point(point, progress);
      if (!record_.has(point)) {
        progress.end("stopped");
        say("stopped; the same command goes on where it was\n");
        return;
      }
      const StudyResult result = record_.result(point, plan_.norm, plan_.measured);
      progress.end(result.valid() ? fmt::format("{} {:.4g}", plan_.quantity(), result.error)
                                  : "failed: " + result.failure);
    }
  }

  /// Table, answers, CSV, figure, and the report where one is asked for.
  void conclude(const std::optional<fs::path>& report) {
    const std::vector<StudyResult> results = this->results();
    const std::vector<OtherPoint> others = plan_.others.empty() ? std::vector<OtherPoint>{} : read_others(plan_.others);
    const StudyAnswers answers = answers_of(plan_, results, others);
    say("\n{}", answers.text());
    record_.json["front"] = names_on_front(results);
    record_.save();
    write_table(folder_ / "study.csv", results);
    const std::string machine = record_.json["machine"];
    draw_study(folder_ / "study.png", plan_, machine, results, others);
    draw_speed(folder_ / "speed.png", plan_, machine, results);
    if (report) write_report(*report, plan_, answers, record_, figures(results));
  }

 private:
  std::vector<std::string> arguments(const StudyPoint& point, const fs::path& folder) const {
    KeyTexts keys = keys_of(plan_, point);
    keys.insert(keys.begin(), {"output.snapshots", "1"});
    return run_arguments(plan_.scene, keys, folder, threads_);
  }

  /// A dry run: seconds that a run of the point will take by a trial of three steps, set-up included.
  double trial(const StudyPoint& point) const {
    std::vector<std::string> words = arguments(point, folder_ / "trial");
    words.push_back("--dry-run");
    const fs::path log = folder_ / "trial.log";
    const Stopwatch watch;
    const int code = run_child(words, log);
    const Json told = last_with("dry_run", log);
    fs::remove(log);
    return watch.wall() + (code == ExitCode::done ? told["dry_run"]["seconds"].get<double>() : 0);
  }

  /// Runs a point as often as asked, after a short trial that warms the machine up; what it found goes into the record.
  void run_point(const StudyPoint& point, StudyProgress& progress) {
    const fs::path folder = folder_ / "points" / point.name();
    fs::create_directories(folder.parent_path());
    const fs::path log = folder.string() + ".log";
    Json runs = Json::array();
    std::string failure;
    double spent = 0;
    trial(point);
    for (int repeat = 0; repeat < plan_.repeat && failure.empty(); ++repeat) {
      const Stopwatch watch;
      const int code =
          run_child(arguments(point, folder), log, [&] { progress.show((repeat + share_done(log)) / plan_.repeat); });
      spent = watch.wall();
      if (stop_requested() || code == ExitCode::stopped) return;
      if (code == ExitCode::done)
        runs.push_back(what_came_of(folder));
      else
        failure = reason_of(code, log);
    }
    expect_measure(plan_, runs);
    if (fs::is_directory(folder))
      for (const auto& file : fs::directory_iterator(folder))
        if (file.path().extension() == ".hdf5") fs::remove(file.path());
    Json keys = Json::object();
    for (const auto& [key, value] : point.keys) keys[key] = value;
    record_.json["points"][point.name()] = {
        {"keys", keys}, {"failure", failure}, {"spent_seconds", spent}, {"runs", runs}};
    record_.save();
  }

  /// Those that this study has drawn now: a folder may hold older ones.
  std::vector<StudyFigure> figures(const std::vector<StudyResult>& results) const {
    std::vector<StudyFigure> drawn{{folder_ / "study.png",
                                    "Error against CPU seconds, against resolution and against pair interactions, and "
                                    "the drift of the energy."}};
    if (!cost_ratios(results).empty())
      drawn.push_back({folder_ / "speed.png", "CPU time of each method over that of the first, at one resolution."});
    return drawn;
  }

  std::vector<StudyResult> results() const {
    std::vector<StudyResult> results;
    for (const StudyPoint& point : plan_.points)
      if (record_.has(point)) results.push_back(record_.result(point, plan_.norm, plan_.measured));
    return results;
  }

  StudyPlan plan_;
  int threads_;
  fs::path folder_;
  StudyRecord record_;
  std::map<std::string, double> expected_;  ///< seconds of the points to run, by name
};

}  // namespace

void study(const StudyRequest& request) {
  StudyPlan plan = asked_plan(request);
  check(plan);
  if (!plan.others.empty()) read_others(plan.others);
  if (request.report) run_plot_script("{}", packages_of_pages);  // before hours of runs
  catch_stop_signals();
  Study study(std::move(plan), request);
  study.announce();
  study.run(request.max_seconds);
  study.conclude(request.report);
}

}  // namespace sphk
