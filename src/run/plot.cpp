// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <nlohmann/json.hpp>

#include "src/engine/errors.hpp"
#include "src/report/plot_script.hpp"
#include "src/schemes/registry.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

/// Does --out name a file, not a folder?
bool is_figure(const std::optional<fs::path>& out) {
  constexpr std::array endings{".png", ".pdf", ".svg", ".jpg"};
  return out && std::ranges::find(endings, out->extension()) != endings.end();
}

/// Name of the figure of one snapshot: --out where that is a file, else beside the snapshot or in the folder of --out,
/// with `ending` behind the snapshot's name.
fs::path figure_name(const PlotRequest& request, const PlotTargets& targets, const fs::path& snapshot,
                     const std::string& ending = "") {
  const bool is_file = is_figure(request.out);
  if (is_file && targets.snapshots.size() > 1)
    throw InputError(fmt::format("--out {}: several snapshots are drawn, so give a folder", request.out->string()));
  if (is_file) return *request.out;
  const fs::path folder = request.out.value_or(targets.folder);
  if (request.out) fs::create_directories(folder);
  return folder / (snapshot.stem().string() + ending + ".png");
}

/// Name of the map beside a figure of profiles.
fs::path map_name(const fs::path& figure) {
  return figure.parent_path() / (figure.stem().string() + "_map" + figure.extension().string());
}

Json references_of(const Problem& problem) {
  Json references = Json::array();
  for (const Reference& r : problem.scene->references(problem.settings))
    references.push_back(
        {{"measure", r.measure}, {"time", r.time}, {"low", r.low}, {"high", r.high}, {"over_start", r.over_start}});
  return references;
}

/// How well the particles of a run sample their kernels.
Json errors_of(const PlotTargets& targets, NumberFiles& files) {
  PlotItem item(targets.snapshots.back(), targets.problem(), files);
  if (!item.has("E0"))
    throw InputError(
        fmt::format("{} holds no E0: run with --set output.errors=true", targets.snapshots.back().string()));
  check_map({}, item);
  item.add_map("rho", {});
  item.add_along({"E0", "P"});
  for (const char* needed : {"x", "rho", "m", "NearestNeighbour"}) item.add_numbers(needed);
  return item.json;
}

/// A field of a run against the exact solution.
Json profile_of(const PlotRequest& request, const PlotTargets& targets, NumberFiles& files) {
  const auto problem = targets.problem();
  PlotItem item(targets.snapshots.back(), problem, files);
  FieldView view = request.view;
  view.field = request.profile;
  check_field(view, item);
  item.add_along({request.profile});
  item.json["history"] = targets.has_history() ? Json(targets.history().string()) : Json(nullptr);
  item.json["label"] = targets.folder.filename().string();
  if (!problem) return item.json;
  if (request.exact) item.add_exact(*problem);
  const SimulationSettings s = simulation_settings(problem->settings);
  item.json["label"] = fmt::format("{} {} {:g}", s.scheme, s.kernel, s.neighbours);
  return item.json;
}

/// How well a run conserves.
Json conservation_of(const PlotTargets& targets) {
  if (!targets.has_history())
    throw InputError(fmt::format("{} holds no history.csv; is it the folder of a run?", targets.folder.string()));
  std::string title = targets.folder.filename().string();
  if (const auto problem = targets.problem()) {
    const SimulationSettings s = simulation_settings(problem->settings);
    title = fmt::format("{}, {} ({}) {} {:g}", problem->scene->name(), s.scheme, s.energy, s.kernel, s.neighbours);
  }
  return {{"history", targets.history().string()}, {"title", title}};
}

/// A snapshot's map.
Json map_of(const FieldView& view, const fs::path& snapshot, const std::optional<Problem>& problem,
            NumberFiles& files) {
  PlotItem item(snapshot, problem, files);
  check_map(view, item);
  item.add_map(view.name(), view.map);
  return item.json;
}

/// One figure of all runs, which the scripts call `kind`; `draws` begins the error where it has no name. One run's
/// needs none where there is an `ending` of it.
void plot_together(const PlotRequest& request, const std::string& kind, const std::string& draws,
                   const std::string& ending, const std::function<Json(const PlotTargets&)>& item_of) {
  const bool named = !is_figure(request.out) && request.what.size() == 1 && !ending.empty();
  if (!is_figure(request.out) && !named) throw InputError(draws + ": name it with --out FILE.png");
  Json runs = Json::array();
  fs::path out = request.out.value_or("");
  for (const std::string& what : request.what) {
    const PlotTargets targets = find_targets(what, false);
    runs.push_back(item_of(targets));
    if (named) out = figure_name(request, targets, targets.snapshots.back(), ending);
  }
  require_same_units(runs);
  const std::string field = request.profile.empty() ? request.view.name() : request.profile;
  run_plot_script(Json{{kind, runs}, {"field", field}, {"view", request.view.json()}, {"out", out.string()}}.dump());
}

/// A map of every snapshot of one run, all on one scale of colours.
void plot_frames(const PlotRequest& request, NumberFiles& files) {
  const PlotTargets targets = find_targets(request.what.front(), true);
  const std::optional<Problem> problem = targets.problem();
  Json frames = Json::array();
  for (const fs::path& snapshot : targets.snapshots) {
    Json item = map_of(request.view, snapshot, problem, files);
    item["map_out"] = figure_name(request, targets, snapshot, "_map_" + request.view.name()).string();
    frames.push_back(std::move(item));
  }
  run_plot_script(Json{{"frames", frames}, {"field", request.view.name()}, {"view", request.view.json()}}.dump());
}

/// The last snapshot of each run, side by side on one scale of colours; or every snapshot of one, a figure each.
void plot_maps(const PlotRequest& request, NumberFiles& files) {
  if (request.every) return plot_frames(request, files);
  const std::string draws = request.view.field.empty() ? "several runs go into one figure, each as a density map"
                                                       : "--field draws one figure for all runs";
  plot_together(request, "maps", draws, "_map_" + request.view.name(), [&](const PlotTargets& targets) {
    return map_of(request.view, targets.snapshots.back(), targets.problem(), files);
  });
}

/// The snapshots of one run or file, a figure each, and its history.
void plot_run(const PlotRequest& request, NumberFiles& files) {
  const PlotTargets targets = find_targets(request.what.front(), request.every);
  const std::optional<Problem> problem = targets.problem();
  Json work = {{"snapshots", Json::array()}, {"history", nullptr}};
  for (const fs::path& snapshot : targets.snapshots) {
    PlotItem item(snapshot, problem, files);
    const fs::path out = figure_name(request, targets, snapshot);
    item.json["out"] = out.string();
    item.json["map_out"] = map_name(out).string();
    item.json["fields"] = item.own_fields();
    item.add_along(item.own_fields());
    if (problem && request.exact) item.add_exact(*problem);
    const bool map = item.suits_map() && item.has("rho") && item.has("m");
    if (map) item.add_map("rho", request.view.map);
    if (map && item.prefers_map() && item.has("alpha")) item.add_map("alpha", request.view.map);  // S12 Fig. 8
    work["snapshots"].push_back(std::move(item.json));
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
  const bool map = !request.view.field.empty(), profile = !request.profile.empty();
  if (map + profile + request.conservation + request.errors > 1)
    throw InputError(
        "--field, --profile, --errors and --conservation each make a figure of their own: give one of them");
  if ((!request.view.range.empty() || request.view.logarithmic) && !map && !profile)
    throw InputError("--range and --log are those of one field: name it with --field FIELD or --profile FIELD");
  request.view.check();
  const MapView& shown = request.view.map;
  if ((!shown.window.empty() || shown.slice || shown.column) && (profile || request.errors || request.conservation))
    throw InputError("--window, --slice and --column are those of maps: leave them out, or name a --field FIELD");
  if (request.every && (request.what.size() > 1 || profile || request.errors || request.conservation))
    throw InputError("--all draws every snapshot of one run, as it is or with --field FIELD");
}

}  // namespace

void plot(const PlotRequest& request) {
  check(request);
  NumberFiles files;
  if (request.conservation)
    return plot_together(request, "conservation", "--conservation draws one figure for all runs", "", conservation_of);
  if (!request.profile.empty())
    return plot_together(request, "profiles", "--profile draws one figure for all runs", "_profile_" + request.profile,
                         [&](const PlotTargets& targets) { return profile_of(request, targets, files); });
  if (request.errors)
    return plot_together(request, "errors", "--errors draws one figure for all runs", "_errors",
                         [&](const PlotTargets& targets) { return errors_of(targets, files); });
  if (request.what.size() == 1 && request.view.field.empty()) return plot_run(request, files);
  plot_maps(request, files);
}

}  // namespace sphk
