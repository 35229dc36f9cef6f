#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "src/cli/child.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/platform.hpp"
#include "src/cli/plot_script.hpp"
#include "src/cli/stop_signal.hpp"
#include "src/cli/study_progress.hpp"
#include "src/cli/study_record.hpp"
#include "src/cli/study_report.hpp"
#include "src/engine/errors.hpp"
#include "src/report/machine.hpp"
#include "src/report/quantity.hpp"
#include "src/report/text_file.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

/// A preset's file, a study file, or the axes of the command line; with the options' own choices.
StudyPlan plan_of(const StudyOptions& options) {
  const std::string& what = options.what[0];
  const fs::path preset = shared_folder() / "studies" / (what + ".toml");
  const bool named = what.find('/') == std::string::npos && fs::exists(preset);
  StudyPlan plan;
  if (named || is_study_file(what)) {
    plan = read_study_file(named ? preset : fs::path(what));
    if (!options.axes.empty())
      throw InputError(fmt::format("{} says itself what it runs; name its scene, {}, to choose on the command line",
                                   what, plan.scene));
  } else {
    plan.scene = what;
    plan.points = product_of(options.axes);
  }
  for (const auto& key : options.fixed) {
    std::erase_if(plan.fixed, [&](const auto& other) { return other.first == key.first; });
    plan.fixed.push_back(key);
  }
  if (!options.norm.empty()) plan.norm = options.norm;
  if (options.target > 0) plan.target = options.target;
  if (!options.budgets.empty()) plan.budgets = options.budgets;
  if (options.repeat > 0) plan.repeat = options.repeat;
  if (!options.others.empty()) plan.others = options.others;
  return plan;
}

/// Throws InputError where a point's keys are none or nothing measures its error, before anything runs. Chooses the
/// norm where nobody did.
void check(StudyPlan& plan) {
  for (const StudyPoint& point : plan.points) {
    std::vector<Override> keys;
    for (const auto* list : {&std::as_const(plan.fixed), &point.keys})
      for (const auto& [key, value] : *list) keys.push_back({key, value, key + "=" + value});
    const Problem problem = resolve_problem(plan.scene, keys);
    if (problem.scene->exact(problem.settings)) {
      if (plan.norm.empty()) plan.norm = "v";
      continue;
    }
    const std::vector<Reference> references = problem.scene->references(problem.settings);
    if (const std::string wanted = problem.scene->keys_with_references(); references.empty())
      throw InputError(fmt::format(
          "{} has neither an exact solution nor values of converged runs{}", plan.scene,
          wanted.empty() ? ", so there is no error to study" : " with these keys; it has them with --set " + wanted));
    if (plan.norm.empty()) plan.norm = references[0].measure;
    if (std::ranges::find(references, plan.norm, &Reference::measure) == references.end())
      throw InputError(fmt::format("{} has no converged values of \"{}\"; take --norm {}", plan.scene, plan.norm,
                                   references[0].measure));
  }
}

class Study {
 public:
  Study(StudyPlan plan, const StudyOptions& options)
      : plan_(std::move(plan)),
        threads_(options.threads),
        folder_(
            options.out.value_or(plan_.name.empty() ? fs::path(plan_.scene).stem().string() + "-study" : plan_.name)) {
    fs::create_directories(folder_);
    record_ = open_record(plan_, folder_);
    record_.json["norm"] = plan_.norm;
  }

  /// Tells how many points are to run and about how long that takes.
  void announce();
  /// Runs what is not in the record. Returns whether that came to its end: --max-time and a request to stop end it
  /// early.
  bool run(double max_seconds);
  /// Table, answers, CSV, figure, and the report where one is asked for.
  void conclude(const std::optional<fs::path>& report) const;

 private:
  std::vector<std::string> arguments(const StudyPoint& point, const fs::path& folder) const;
  /// A dry run: seconds that a run of the point will take by a trial of three steps, set-up included.
  double trial(const StudyPoint& point) const;
  void run_point(const StudyPoint& point, StudyProgress& progress);
  std::vector<StudyResult> results() const;
  void draw(const std::vector<StudyResult>& results, const std::vector<OtherPoint>& others) const;

  StudyPlan plan_;
  int threads_;
  fs::path folder_;
  StudyRecord record_;
  std::map<std::string, double> expected_;  ///< seconds of the points to run, by name
};

std::vector<std::string> Study::arguments(const StudyPoint& point, const fs::path& folder) const {
  std::vector<std::string> words{"run", plan_.scene, "--out", folder.string(), "--overwrite", "--json-log"};
  const auto set = [&](const std::string& key, const std::string& value) {
    words.insert(words.end(), {"--set", key + "=" + value});
  };
  set("output.snapshots", "1");
  for (const auto& [key, value] : plan_.fixed) set(key, value);
  for (const auto& [key, value] : point.keys) set(key, value);
  if (threads_ > 0) words.insert(words.end(), {"--threads", std::to_string(threads_)});
  return words;
}

double Study::trial(const StudyPoint& point) const {
  std::vector<std::string> words = arguments(point, folder_ / "trial");
  words.push_back("--dry-run");
  const fs::path file = folder_ / "trial.log";
  const Stopwatch watch;
  const int code = run_child(words, file);
  std::stringstream log;
  log << std::ifstream(file).rdbuf();
  fs::remove(file);
  const std::string text = log.str();
  std::smatch steps, seconds;
  if (code != ExitCode::done || !std::regex_search(text, steps, std::regex("steps +about ([0-9]+)")) ||
      !std::regex_search(text, seconds, std::regex("\\(([0-9.e+-]+) s a step")))
    return watch.wall();
  return watch.wall() + std::stod(steps[1]) * std::stod(seconds[1]);
}

void Study::announce() {
  double expected = 0;
  for (const StudyPoint& point : plan_.points) {
    if (record_.has(point) || stop_requested()) continue;
    expected_[point.name()] = plan_.repeat * trial(point);
    expected += expected_[point.name()];
  }
  fmt::print("{} points of {}, {} of them to run, {} in {}{}\n", plan_.points.size(), plan_.scene, expected_.size(),
             plan_.repeat == 1 ? "once each" : fmt::format("{} times each", plan_.repeat), folder_.string(),
             expected_.empty() ? "" : "; about " + duration_text(expected));
  std::fflush(stdout);
}

/// Runs a point as often as asked, after a short trial that warms the machine up; what it found goes into the record.
void Study::run_point(const StudyPoint& point, StudyProgress& progress) {
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
      runs.push_back(read_json(folder / "run.json"));
    else
      failure = reason_of(code, log);
  }
  if (fs::is_directory(folder))
    for (const auto& file : fs::directory_iterator(folder))
      if (file.path().extension() == ".hdf5") fs::remove(file.path());
  Json keys = Json::object();
  for (const auto& [key, value] : point.keys) keys[key] = value;
  record_.json["points"][point.name()] = {
      {"keys", keys}, {"failure", failure}, {"spent_seconds", spent}, {"runs", runs}};
  record_.save();
}

bool Study::run(double max_seconds) {
  const Stopwatch watch;
  StudyProgress progress(plan_.points.size(), expected_);
  for (std::size_t k = 0; k < plan_.points.size(); ++k) {
    const StudyPoint& point = plan_.points[k];
    if (record_.has(point)) continue;
    if (max_seconds > 0 && watch.wall() > max_seconds) {
      fmt::print("--max-time {:g} s is over: the same command goes on with the rest\n", max_seconds);
      return false;
    }
    progress.begin(k, point);
    run_point(point, progress);
    if (!record_.has(point)) {
      progress.end("stopped");
      fmt::print("stopped; the same command goes on where it was\n");
      return false;
    }
    const StudyResult result = result_of(point, record_.json["points"][point.name()], plan_.norm);
    progress.end(result.valid() ? fmt::format("L1({}) {:.4g}", plan_.norm, result.error) : "failed: " + result.failure);
  }
  return true;
}

std::vector<StudyResult> Study::results() const {
  std::vector<StudyResult> results;
  for (const StudyPoint& point : plan_.points)
    if (record_.has(point)) results.push_back(result_of(point, record_.json["points"][point.name()], plan_.norm));
  return results;
}

void Study::draw(const std::vector<StudyResult>& results, const std::vector<OtherPoint>& others) const {
  Json lines = Json::array();
  for (const auto& group : by_method(results)) {
    Json line = {{"method", group[0].point.method()}, {"points", Json::array()}};
    const auto order = fitted_order(group);
    line["order"] = order ? Json(*order) : Json(nullptr);
    for (const StudyResult& r : group)
      line["points"].push_back(
          {{"n", r.n}, {"error", r.error}, {"cpu", r.cpu}, {"pairs", r.pairs}, {"drift", r.energy_drift}});
    lines.push_back(line);
  }
  if (lines.empty()) return;
  Json failures = Json::array(), elsewhere = Json::array();
  for (const StudyResult& r : results)
    if (!r.valid()) failures.push_back({{"method", r.point.method()}, {"n", r.n}, {"cpu", r.cpu}});
  for (const OtherPoint& o : others)
    elsewhere.push_back(
        {{"engine", o.engine}, {"setting", o.setting}, {"error", o.error}, {"cpu", o.cpu}, {"machine", o.machine}});
  run_plot_script(Json{{"study", lines},
                       {"failures", failures},
                       {"others", elsewhere},
                       {"norm", plan_.norm},
                       {"relative", !is_field_error(plan_.norm)},
                       {"title", fmt::format("{} on {}", plan_.scene, record_.json["machine"].get<std::string>())},
                       {"target", plan_.target},
                       {"out", (folder_ / "study.png").string()}}
                      .dump());
}

void write_csv(const fs::path& path, const std::vector<StudyResult>& results) {
  std::string csv =
      "method,n,particles,error,energy_drift,steps,wall_seconds,cpu_seconds,updates,pairs,memory,joules,failure\n";
  for (const StudyResult& r : results)
    csv += fmt::format("\"{}\",{},{},{:.9g},{:.3g},{},{:.6g},{:.6g},{},{},{},{},\"{}\"\n", r.point.method(), r.n,
                       r.particles, r.error, r.energy_drift, r.steps, r.wall, r.cpu, r.updates, r.pairs, r.bytes,
                       r.joules ? fmt::format("{:.6g}", *r.joules) : "",
                       std::regex_replace(r.failure, std::regex("[\"\n]+"), " "));
  write_text(path, csv);
}

void Study::conclude(const std::optional<fs::path>& report) const {
  const std::vector<StudyResult> results = this->results();
  const std::vector<OtherPoint> others = plan_.others.empty() ? std::vector<OtherPoint>{} : read_others(plan_.others);
  const StudyAnswers answers = answers_of(plan_, results, others);
  fmt::print("\n{}", answers.text());
  write_csv(folder_ / "study.csv", results);
  draw(results, others);
  if (report) {
    write_text(*report, report_page(plan_, answers, record_, folder_ / "study.png"));
    fmt::print("{}\n", report->string());
  }
}

}  // namespace

int study_command(const StudyOptions& options) {
  StudyPlan plan = plan_of(options);
  check(plan);
  if (!plan.others.empty()) read_others(plan.others);
  catch_stop_signals();
  Study study(std::move(plan), options);
  study.announce();
  study.run(options.max_seconds);
  study.conclude(options.report);
  return stop_requested() ? ExitCode::stopped : ExitCode::done;
}

}  // namespace sphk
