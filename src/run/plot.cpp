#include "src/run/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <nlohmann/json.hpp>

#include "src/engine/errors.hpp"
#include "src/io/hdf5_file.hpp"
#include "src/io/input_file.hpp"
#include "src/report/plot_script.hpp"
#include "src/run/plot_fields.hpp"
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
  /// Throws InputError where it is no file.
  bool has_history() const {
    if (!fs::exists(history())) return false;
    require_file(history());
    return true;
  }
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
  constexpr std::array endings{".png", ".pdf", ".svg", ".jpg"};
  return out && std::ranges::find(endings, out->extension()) != endings.end();
}

/// Name of the figure of one snapshot: --out where that is a file, else beside the snapshot or in the folder of --out,
/// with `ending` behind the snapshot's name.
fs::path figure_name(const PlotRequest& request, const Targets& targets, const fs::path& snapshot,
                     const std::string& ending = "") {
  const bool is_file = is_figure(request.out);
  if (is_file && targets.snapshots.size() > 1)
    throw InputError(fmt::format("--out {}: several snapshots are drawn, so give a folder", request.out->string()));
  if (is_file) return *request.out;
  const fs::path folder = request.out.value_or(targets.folder);
  if (request.out) fs::create_directories(folder);
  return folder / (snapshot.stem().string() + ending + ".png");
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

/// A snapshot of which a map is drawn.
Json map_of(const fs::path& snapshot, const std::optional<Problem>& problem) {
  Json map = describe_snapshot(snapshot, problem, false);
  if (map["dimension"] == 1)
    throw InputError(
        fmt::format("{} is one-dimensional: it has no map; --profile draws a field along x", snapshot.string()));
  if (map["names"].contains("|v|")) map["names"]["v"] = map["names"]["|v|"];  // it has no direction of its own
  for (const char* needed : {"rho", "m"})
    if (!map["names"].contains(needed))
      throw InputError(fmt::format("{} holds no densities or masses, which maps need; snapshots of `sphk run` do",
                                   snapshot.string()));
  return map;
}

/// How well the particles of a run sample their kernels.
Json errors_of(const Targets& targets) {
  const fs::path& snapshot = targets.snapshots.back();
  if (!hdf5::File::open(snapshot).group("PartType0").has("E0"))
    throw InputError(fmt::format("{} holds no E0: run with --set output.errors=true", snapshot.string()));
  return map_of(snapshot, problem_of(targets));
}

/// Throws InputError unless every snapshot has the field, and positive values of it where the scale is logarithmic.
void check_field(const PlotRequest& request, const std::string& name, const Json& item) {
  const fs::path snapshot = item["file"].get<std::string>();
  PlotField field = find_plot_field(plot_fields(snapshot, item["dimension"]), name, snapshot);
  field.part = item["names"][name][1];
  if (!request.logarithmic || !request.range.empty()) return;
  const bool signed_part = field.part == "R" || field.part == "phi" || field.part == "r";
  if (const double least = signed_part ? -1 : least_value(field, snapshot); !(least > 0))
    throw InputError(
        fmt::format("--log: {} is not positive everywhere in {}{}: leave --log out, or give a range above "
                    "0 with --range LO,HI",
                    name, snapshot.string(), signed_part ? "" : fmt::format(" (the least is {:g})", least)));
}

/// A field of a run against the exact solution.
Json profile_of(const PlotRequest& request, const Targets& targets) {
  const auto problem = problem_of(targets);
  Json item = describe_snapshot(targets.snapshots.back(), problem, request.exact);
  check_field(request, request.profile, item);
  item["history"] = targets.has_history() ? Json(targets.history().string()) : Json(nullptr);
  item["label"] = targets.folder.filename().string();
  if (problem) {
    const SimulationSettings s = simulation_settings(problem->settings);
    item["label"] = fmt::format("{} {} {:g}", s.scheme, s.kernel, s.neighbours);
  }
  return item;
}

/// How well a run conserves.
Json conservation_of(const Targets& targets) {
  if (!targets.has_history())
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

/// The range and scale of a field's colours or axis.
Json view_of(const PlotRequest& request) {
  return {{"range", request.range.empty() ? Json(nullptr) : Json(request.range)}, {"log", request.logarithmic}};
}

/// One figure of all runs, which the script calls `kind`; `draws` begins the error where it has no name. One run's
/// needs none where there is an `ending` of it.
void plot_together(const PlotRequest& request, const std::string& kind, const std::string& draws,
                   const std::string& ending, const std::function<Json(const Targets&)>& item_of) {
  const bool named = !is_figure(request.out) && request.what.size() == 1 && !ending.empty();
  if (!is_figure(request.out) && !named) throw InputError(draws + ": name it with --out FILE.png");
  Json runs = Json::array();
  fs::path out = request.out.value_or("");
  for (const std::string& what : request.what) {
    const Targets targets = find_targets(what, false);
    runs.push_back(item_of(targets));
    if (named) out = figure_name(request, targets, targets.snapshots.back(), ending);
  }
  require_same_units(runs);
  const std::string field = request.map.empty() ? request.profile : request.map;
  run_plot_script(Json{{kind, runs}, {"field", field}, {"view", view_of(request)}, {"out", out.string()}}.dump());
}

/// A map of every snapshot of one run, all on one scale of colours.
void plot_frames(const PlotRequest& request) {
  const Targets targets = find_targets(request.what.front(), true);
  const std::optional<Problem> problem = problem_of(targets);
  Json frames = Json::array();
  for (const fs::path& snapshot : targets.snapshots) {
    Json item = map_of(snapshot, problem);
    check_field(request, request.map, item);
    item["out"] = figure_name(request, targets, snapshot, "_map_" + request.map).string();
    frames.push_back(std::move(item));
  }
  run_plot_script(Json{{"frames", frames}, {"field", request.map}, {"view", view_of(request)}}.dump());
}

/// The last snapshot of each run, side by side on one scale of colours; or every snapshot of one, a figure each.
void plot_maps(PlotRequest request) {
  const bool asked = !request.map.empty();
  if (!asked) request.map = "rho";
  if (request.every) return plot_frames(request);
  plot_together(
      request, "maps",
      asked ? "--map draws one figure for all runs" : "several runs go into one figure, each as a density map",
      "_map_" + request.map, [&](const Targets& targets) {
        Json item = map_of(targets.snapshots.back(), problem_of(targets));
        check_field(request, request.map, item);
        return item;
      });
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
  const bool there = targets.has_history();
  if (there) work["history"] = targets.history().string();
  work["references"] = problem ? references_of(*problem) : Json::array();
  if (there && targets.whole_run && !is_figure(request.out))
    work["history_out"] = (request.out.value_or(targets.folder) / "history.png").string();
  run_plot_script(work.dump());
}

/// Throws InputError where wishes contradict each other.
void check(const PlotRequest& request) {
  const auto& out = request.out;
  if (out && out->has_extension() && !is_figure(out) && !fs::is_directory(*out))
    throw InputError(
        fmt::format("--out {}: figures are .png, .pdf, .svg or .jpg files, so write {}; or a folder, made "
                    "before or with a slash at its end",
                    out->string(), fs::path(*out).replace_extension(".png").string()));
  const bool map = !request.map.empty(), profile = !request.profile.empty();
  if (map + profile + request.conservation + request.errors > 1)
    throw InputError("--map, --profile, --errors and --conservation each make a figure of their own: give one of them");
  if ((!request.range.empty() || request.logarithmic) && !map && !profile)
    throw InputError("--range and --log are those of one field: name it with --map FIELD or --profile FIELD");
  if (!request.range.empty() && !(request.range[0] < request.range[1]))
    throw InputError(
        fmt::format("--range {:g},{:g}: the first number must be the smaller one", request.range[0], request.range[1]));
  if (request.logarithmic && !request.range.empty() && !(request.range[0] > 0))
    throw InputError(
        fmt::format("--range {:g},{:g} with --log: both numbers must be above 0", request.range[0], request.range[1]));
  if (request.every && (request.what.size() > 1 || profile || request.errors || request.conservation))
    throw InputError("--all draws every snapshot of one run, as it is or with --map FIELD");
}

}  // namespace

void plot(const PlotRequest& request) {
  check(request);
  if (request.conservation)
    return plot_together(request, "conservation", "--conservation draws one figure for all runs", "", conservation_of);
  if (!request.profile.empty())
    return plot_together(request, "profiles", "--profile draws one figure for all runs", "_profile_" + request.profile,
                         [&](const Targets& targets) { return profile_of(request, targets); });
  if (request.errors)
    return plot_together(request, "errors", "--errors draws one figure for all runs", "_errors", errors_of);
  if (request.what.size() == 1 && request.map.empty()) return plot_run(request);
  plot_maps(request);
}

}  // namespace sphk
