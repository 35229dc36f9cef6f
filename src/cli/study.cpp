#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "src/cli/plot_script.hpp"
#include "src/cli/study_record.hpp"
#include "src/engine/errors.hpp"
#include "src/report/machine.hpp"
#include "src/report/quantity.hpp"
#include "src/report/text_file.hpp"
#include "src/study/presets.hpp"

extern char** environ;

namespace sphk {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

/// Exit code of this executable with these arguments, its output in `log`.
int run_self(const std::vector<std::string>& arguments, const fs::path& log) {
  std::vector<std::string> words{fs::read_symlink("/proc/self/exe").string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  pid_t child = 0;
  const int error = posix_spawn(&child, words[0].c_str(), &files, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0) throw InputError(fmt::format("cannot start {}", words[0]));
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// The last line of a run's log that says error, or the last line at all.
std::string reason_in(const fs::path& log) {
  std::ifstream file(log);
  std::string line, last;
  while (std::getline(file, line))
    if (line.starts_with("error:"))
      return line.substr(7);
    else if (!line.empty())
      last = line;
  return last.empty() ? "no output" : last;
}

std::vector<std::string> arguments_of(const StudyOptions& options, const StudyPoint& point, const fs::path& folder) {
  std::vector<std::string> arguments{"run", options.scene, "--out", folder.string(), "--overwrite"};
  const auto set = [&](const std::string& key, const std::string& value) {
    arguments.insert(arguments.end(), {"--set", key + "=" + value});
  };
  set("output.snapshots", "1");
  for (const auto& [key, value] : options.fixed) set(key, value);
  for (const auto& [key, value] : point.keys) set(key, value);
  if (options.threads > 0) arguments.insert(arguments.end(), {"--threads", std::to_string(options.threads)});
  return arguments;
}

/// Throws InputError where a point's keys are none, before anything runs.
void check(const StudyOptions& options, const std::vector<StudyPoint>& points) {
  for (const StudyPoint& point : points) {
    std::vector<Override> keys;
    for (const auto* list : {&options.fixed, &point.keys})
      for (const auto& [key, value] : *list) keys.push_back({key, value, key + "=" + value});
    resolve_problem(options.scene, keys);
  }
}

/// Seconds that a run of the point will take, from a trial of three steps; 0 where the trial fails.
double expected_seconds(const StudyOptions& options, const StudyPoint& point, const fs::path& folder) {
  std::vector<std::string> arguments = arguments_of(options, point, folder / "trial");
  arguments.push_back("--dry-run");
  if (run_self(arguments, folder / "trial.log") != ExitCode::done) return 0;
  std::ifstream file(folder / "trial.log");
  const std::string log{std::istreambuf_iterator<char>(file), {}};
  std::smatch steps, seconds;
  if (!std::regex_search(log, steps, std::regex("steps +about ([0-9]+)")) ||
      !std::regex_search(log, seconds, std::regex("\\(([0-9.e+-]+) s a step")))
    return 0;
  return std::stod(steps[1]) * std::stod(seconds[1]);
}

/// Tells how many points are to run and about how long that takes.
void announce(const StudyOptions& options, const std::vector<StudyPoint>& points, const StudyRecord& record) {
  double expected = 0;
  int waiting = 0;
  for (const StudyPoint& point : points) {
    if (record.has(point)) continue;
    ++waiting;
    expected += options.repeat * expected_seconds(options, point, record.file.parent_path());
  }
  fmt::print("{} points of {}, {} of them to run, {} times each, in {}{}\n", points.size(), options.scene, waiting,
             options.repeat, record.file.parent_path().string(),
             waiting > 0 ? "; about " + duration_text(expected) : "");
  fs::remove(record.file.parent_path() / "trial.log");
}

/// Runs a point as often as asked; what it found goes into the record.
void run_point(const StudyOptions& options, const StudyPoint& point, StudyRecord& record) {
  const fs::path folder = record.file.parent_path() / "points" / point.name();
  fs::create_directories(folder.parent_path());
  const fs::path log = folder.string() + ".log";
  Json runs = Json::array();
  std::string failure;
  for (int repeat = 0; repeat < options.repeat && failure.empty(); ++repeat) {
    const int code = run_self(arguments_of(options, point, folder), log);
    if (code == ExitCode::stopped) throw InputError("stopped; the same command goes on where it was");
    if (code == ExitCode::done)
      runs.push_back(read_json(folder / "run.json"));
    else
      failure = reason_in(log);
  }
  for (const auto& entry : fs::directory_iterator(folder.parent_path()))
    if (entry.path() == folder) {
      for (const auto& file : fs::directory_iterator(folder))
        if (file.path().extension() == ".hdf5") fs::remove(file.path());
    }
  Json keys = Json::object();
  for (const auto& [key, value] : point.keys) keys[key] = value;
  record.json["points"][point.name()] = {{"keys", keys}, {"failure", failure}, {"runs", runs}};
  record.save();
}

void write_csv(const fs::path& path, const std::vector<StudyResult>& results) {
  std::string csv =
      "method,n,particles,error,energy_drift,steps,wall_seconds,cpu_seconds,updates,pairs,memory,failure\n";
  for (const StudyResult& r : results)
    csv +=
        fmt::format("\"{}\",{},{},{:.9g},{:.3g},{},{:.6g},{:.6g},{},{},{},\"{}\"\n", r.point.method(), r.n, r.particles,
                    r.error, r.energy_drift, r.steps, r.wall, r.cpu, r.updates, r.pairs, r.bytes, r.failure);
  write_text(path, csv);
}

void draw(const fs::path& path, const StudyOptions& options, const std::vector<StudyResult>& results) {
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
  run_plot_script(Json{
      {"study", lines},
      {"norm", options.norm},
      {"title", fmt::format("{} on {}", options.scene, machine_name())},
      {"target", options.target},
      {"out",
       path.string()}}.dump());
}

}  // namespace

int study_command(const StudyOptions& given) {
  StudyOptions options = given;
  std::vector<StudyPoint> points = product_of(options.axes);
  const auto& presets = study_presets();
  const auto preset = std::ranges::find(presets, options.scene, &StudyPreset::name);
  if (preset != presets.end()) {
    if (!options.axes.empty())
      throw InputError(fmt::format("{} is a preset and says what it runs; name its scene, {}, to choose yourself",
                                   preset->name, preset->scene));
    points = preset->points;
    options.fixed.insert(options.fixed.begin(), preset->fixed.begin(), preset->fixed.end());
    options.scene = preset->scene;
    if (options.norm.empty()) options.norm = preset->norm;
    if (options.target == 0) options.target = preset->target;
    if (!options.out) options.out = preset->name;
  }
  if (options.norm.empty()) options.norm = "v";
  check(options, points);
  const fs::path folder = options.out.value_or(options.scene + "-study");
  fs::create_directories(folder);
  StudyRecord record = open_record(options, folder);
  announce(options, points, record);
  const Stopwatch watch;
  std::size_t done = 0;
  for (const StudyPoint& point : points) {
    ++done;
    if (record.has(point)) continue;
    if (options.max_seconds > 0 && watch.wall() > options.max_seconds) {
      fmt::print("--max-time {:g} s is over: the same command goes on with the rest\n", options.max_seconds);
      break;
    }
    fmt::print("[{}/{}] {} n = {} ...", done, points.size(), point.method(), point.value(resolution_key));
    std::fflush(stdout);
    const double start = watch.wall();
    run_point(options, point, record);
    fmt::print(" {}\n", duration_text(watch.wall() - start));
  }
  std::vector<StudyResult> results;
  for (const StudyPoint& point : points)
    if (record.has(point)) results.push_back(result_of(point, record.json["points"][point.name()], options.norm));
  fmt::print("\n{}", study_table(results, options.norm));
  if (options.target > 0) fmt::print("{}", target_lines(results, options.target));
  write_csv(folder / "study.csv", results);
  draw(folder / "study.png", options, results);
  return ExitCode::done;
}

}  // namespace sphk
