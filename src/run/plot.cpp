#include "src/run/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "src/engine/errors.hpp"
#include "src/io/hdf5_file.hpp"
#include "src/report/plot_script.hpp"
#include "src/run/plot_items.hpp"
#include "src/schemes/registry.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

/// The snapshots to draw and the folder of their run.
struct Targets {
  fs::path folder;
  std::vector<fs::path> snapshots;
  bool whole_run = false;
};

std::vector<fs::path> snapshots_in(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("snap_") && name.ends_with(".hdf5")) found.push_back(entry.path());
  }
  std::ranges::sort(found);
  return found;
}

Targets find_targets(const fs::path& what, bool every) {
  if (fs::is_regular_file(what)) return {.folder = what.parent_path(), .snapshots = {what}, .whole_run = false};
  if (!fs::is_directory(what))
    throw InputError(
        fmt::format("{} is neither a run's folder nor a snapshot; `sphk run SCENE` makes a folder", what.string()));
  Targets targets{.folder = what, .snapshots = snapshots_in(what), .whole_run = true};
  if (targets.snapshots.empty())
    throw InputError(
        fmt::format("{} holds no snapshots (snap_0000.hdf5, ...); is it the folder of a run?", what.string()));
  if (!every) targets.snapshots.erase(targets.snapshots.begin(), targets.snapshots.end() - 1);
  return targets;
}

/// Does --out name a file, not a folder?
bool is_figure(const std::optional<fs::path>& out) {
  return out && out->extension() == ".png";
}

/// Figure names: `--out FILE.png` for a single snapshot, else beside the snapshots or in the folder of --out.
fs::path figure_name(const PlotRequest& request, const Targets& targets, const fs::path& snapshot) {
  const bool is_file = is_figure(request.out);
  if (is_file && targets.snapshots.size() > 1)
    throw InputError(fmt::format("--out {}: several snapshots are drawn, so give a folder", request.out->string()));
  if (is_file) return *request.out;
  const fs::path folder = request.out.value_or(targets.folder);
  if (request.out) fs::create_directories(folder);
  return folder / snapshot.filename().replace_extension(".png");
}

/// The file of the only figure; without one an error that begins with `what` is drawn.
std::string figure_of(const PlotRequest& request, const std::string& what) {
  if (!is_figure(request.out)) throw InputError(what + ": name it with --out FILE.png");
  return request.out->string();
}

std::optional<Problem> problem_of(const Targets& targets) {
  const fs::path scene_file = targets.folder / "scene.used.toml";
  if (!fs::exists(scene_file)) return std::nullopt;
  return resolve_problem(scene_file.string(), {});
}

Json references_of(const Problem& problem) {
  Json references = Json::array();
  for (const Reference& r : problem.scene->references(problem.settings))
    references.push_back(
        {{"measure", r.measure}, {"time", r.time}, {"low", r.low}, {"high", r.high}, {"over_start", r.over_start}});
  return references;
}

/// The density maps of several runs or snapshots, on one scale, in one figure.
void plot_side_by_side(const PlotRequest& request) {
  const std::string out = figure_of(request, "several runs go into one figure, each as a density map");
  if (request.every) throw InputError("--all draws every snapshot of one run; several runs are given");
  Json maps = Json::array();
  for (const std::string& what : request.what) {
    const Targets targets = find_targets(what, false);
    maps.push_back(describe_snapshot(targets.snapshots.back(), problem_of(targets), false));
    if (maps.back()["dimension"] == 1)
      throw InputError(fmt::format("{} is one-dimensional and has no density map", what));
  }
  run_plot_script(Json{{"beside", maps}, {"out", out}}.dump());
}

/// How well the particles of runs sample their kernels, in one figure.
void plot_errors(const PlotRequest& request) {
  const std::string out = figure_of(request, "--errors draws one figure for all runs");
  Json runs = Json::array();
  for (const std::string& what : request.what) {
    const Targets targets = find_targets(what, false);
    const fs::path& snapshot = targets.snapshots.back();
    if (!hdf5::File::open(snapshot).group("PartType0").has("E0"))
      throw InputError(fmt::format("{} holds no E0: run with --set output.errors=true", snapshot.string()));
    runs.push_back(describe_snapshot(snapshot, problem_of(targets), false));
    if (runs.back()["dimension"] == 1)
      throw InputError(fmt::format("{} is one-dimensional: --errors draws maps and lines along y", what));
  }
  run_plot_script(Json{{"errors", runs}, {"out", out}}.dump());
}

/// One field of several runs against the exact solution, a panel each.
void plot_profiles(const PlotRequest& request) {
  const std::string out = figure_of(request, "--profile draws one figure for all runs");
  Json runs = Json::array();
  for (const std::string& what : request.what) {
    const Targets targets = find_targets(what, false);
    const auto problem = problem_of(targets);
    Json item = describe_snapshot(targets.snapshots.back(), problem, request.exact);
    const fs::path history = targets.folder / "history.csv";
    item["history"] = fs::exists(history) ? Json(history.string()) : Json(nullptr);
    item["label"] = targets.folder.filename().string();
    if (problem) {
      const SimulationSettings s = simulation_settings(problem->settings);
      item["label"] = fmt::format("{} {} {:g}", s.scheme, s.kernel, s.neighbours);
    }
    runs.push_back(item);
  }
  run_plot_script(Json{{"profiles", runs}, {"field", request.profile}, {"out", out}}.dump());
}

/// How well one or several runs conserve, in one figure.
void plot_conservation(const PlotRequest& request) {
  const std::string out = figure_of(request, "--conservation draws one figure for all runs");
  Json runs = Json::array();
  for (const std::string& what : request.what) {
    const Targets targets = find_targets(what, false);
    const fs::path history = targets.folder / "history.csv";
    if (!fs::exists(history))
      throw InputError(fmt::format("{} holds no history.csv; is it the folder of a run?", targets.folder.string()));
    const auto problem = problem_of(targets);
    std::string title = targets.folder.filename().string();
    if (problem) {
      const SimulationSettings s = simulation_settings(problem->settings);
      title = fmt::format("{}, {} ({}) {} {:g}", problem->scene->name(), s.scheme, s.energy, s.kernel, s.neighbours);
    }
    runs.push_back({{"history", history.string()}, {"title", title}});
  }
  run_plot_script(Json{{"conservation", runs}, {"out", out}}.dump());
}

/// The snapshots of one run or file, a figure each, and its history.
void plot_run(const PlotRequest& request) {
  const Targets targets = find_targets(request.what.front(), request.every);
  const std::optional<Problem> problem = problem_of(targets);
  Json work = {{"snapshots", Json::array()}, {"history", nullptr}};
  for (const fs::path& snapshot : targets.snapshots) {
    Json item = describe_snapshot(snapshot, problem, request.exact);
    item["out"] = figure_name(request, targets, snapshot).string();
    work["snapshots"].push_back(std::move(item));
  }
  const fs::path history = targets.folder / "history.csv";
  if (fs::exists(history)) work["history"] = history.string();
  work["references"] = problem ? references_of(*problem) : Json::array();
  const bool draw_history = targets.whole_run && fs::exists(history) && !is_figure(request.out);
  if (draw_history) work["history_out"] = (request.out.value_or(targets.folder) / "history.png").string();
  run_plot_script(work.dump());
}

}  // namespace

void plot(const PlotRequest& request) {
  if (request.conservation) return plot_conservation(request);
  if (!request.profile.empty()) return plot_profiles(request);
  if (request.errors) return plot_errors(request);
  if (request.what.size() > 1) return plot_side_by_side(request);
  plot_run(request);
}

}  // namespace sphk
