#include "src/run/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
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
  fs::path what, folder;  ///< as the user says; of the run
  std::vector<fs::path> snapshots;
  bool whole_run = false;

  fs::path history() const { return folder / "history.csv"; }
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
  if (fs::is_regular_file(what)) return {what, what.parent_path(), {what}, false};
  if (!fs::is_directory(what))
    throw InputError(
        fmt::format("{} is neither a run's folder nor a snapshot; `sphk run SCENE` makes a folder", what.string()));
  Targets targets{what, what, snapshots_in(what), true};
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

std::optional<Problem> problem_of(const Targets& targets) {
  const fs::path scene_file = targets.folder / "scene.used.toml";
  if (!fs::exists(scene_file)) return std::nullopt;
  return resolve_run(SceneFile(scene_file), targets.snapshots.back());
}

Json references_of(const Problem& problem) {
  Json references = Json::array();
  for (const Reference& r : problem.scene->references(problem.settings))
    references.push_back(
        {{"measure", r.measure}, {"time", r.time}, {"low", r.low}, {"high", r.high}, {"over_start", r.over_start}});
  return references;
}

/// A density map; `why_not` ends the sentence on gas in one dimension, which has none.
Json map_of(const Targets& targets, const std::string& why_not) {
  Json map = describe_snapshot(targets.snapshots.back(), problem_of(targets), false);
  if (map["dimension"] == 1) throw InputError(fmt::format("{} is one-dimensional{}", targets.what.string(), why_not));
  return map;
}

/// How well the particles of a run sample their kernels.
Json errors_of(const Targets& targets) {
  const fs::path& snapshot = targets.snapshots.back();
  if (!hdf5::File::open(snapshot).group("PartType0").has("E0"))
    throw InputError(fmt::format("{} holds no E0: run with --set output.errors=true", snapshot.string()));
  return map_of(targets, ": --errors draws maps and lines along y");
}

/// A run against the exact solution.
Json profile_of(const Targets& targets, bool exact) {
  const auto problem = problem_of(targets);
  Json item = describe_snapshot(targets.snapshots.back(), problem, exact);
  item["history"] = fs::exists(targets.history()) ? Json(targets.history().string()) : Json(nullptr);
  item["label"] = targets.folder.filename().string();
  if (problem) {
    const SimulationSettings s = simulation_settings(problem->settings);
    item["label"] = fmt::format("{} {} {:g}", s.scheme, s.kernel, s.neighbours);
  }
  return item;
}

/// How well a run conserves.
Json conservation_of(const Targets& targets) {
  if (!fs::exists(targets.history()))
    throw InputError(fmt::format("{} holds no history.csv; is it the folder of a run?", targets.folder.string()));
  std::string title = targets.folder.filename().string();
  if (const auto problem = problem_of(targets)) {
    const SimulationSettings s = simulation_settings(problem->settings);
    title = fmt::format("{}, {} ({}) {} {:g}", problem->scene->name(), s.scheme, s.energy, s.kernel, s.neighbours);
  }
  return {{"history", targets.history().string()}, {"title", title}};
}

/// Pictures on one scale show numbers of one unit.
void require_same_units(const Json& runs) {
  const auto units = [](const Json& run) { return run.contains("units") ? run["units"] : Json(); };
  const auto same = [&](const Json& run, const char* quantity) {
    const auto name = [&](const Json& of) { return of.is_null() ? Json() : of[quantity]; };
    return name(units(run)) == name(units(runs.front()));
  };
  for (const Json& run : runs)
    if (!same(run, "x") || !same(run, "m") || !same(run, "t"))
      throw InputError(fmt::format("{} and {} are in different units: draw them in a figure each",
                                   runs.front()["file"].get<std::string>(), run["file"].get<std::string>()));
}

/// One figure of all runs, which the script calls `kind`; `draws` begins the error where it has no name.
void plot_together(const PlotRequest& request, const std::string& kind, const std::string& draws,
                   const std::function<Json(const Targets&)>& item_of) {
  if (!is_figure(request.out)) throw InputError(draws + ": name it with --out FILE.png");
  Json runs = Json::array();
  for (const std::string& what : request.what) runs.push_back(item_of(find_targets(what, false)));
  require_same_units(runs);
  run_plot_script(Json{{kind, runs}, {"field", request.profile}, {"out", request.out->string()}}.dump());
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
  const bool there = fs::exists(targets.history());
  if (there) work["history"] = targets.history().string();
  work["references"] = problem ? references_of(*problem) : Json::array();
  if (there && targets.whole_run && !is_figure(request.out))
    work["history_out"] = (request.out.value_or(targets.folder) / "history.png").string();
  run_plot_script(work.dump());
}

}  // namespace

void plot(const PlotRequest& request) {
  if (const auto& out = request.out; out && out->has_extension() && !is_figure(out) && !fs::is_directory(*out))
    throw InputError(
        fmt::format("--out {}: figures are PNG files, so write {}; or a folder, made before or with a "
                    "slash at its end",
                    out->string(), fs::path(*out).replace_extension(".png").string()));
  if (request.conservation)
    return plot_together(request, "conservation", "--conservation draws one figure for all runs", conservation_of);
  if (!request.profile.empty())
    return plot_together(request, "profiles", "--profile draws one figure for all runs",
                         [&](const Targets& targets) { return profile_of(targets, request.exact); });
  if (request.errors) return plot_together(request, "errors", "--errors draws one figure for all runs", errors_of);
  if (request.what.size() == 1) return plot_run(request);
  if (request.every && is_figure(request.out))
    throw InputError("--all draws every snapshot of one run; several runs are given");
  plot_together(request, "beside", "several runs go into one figure, each as a density map",
                [](const Targets& targets) { return map_of(targets, " and has no density map"); });
}

}  // namespace sphk
