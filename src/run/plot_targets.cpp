// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/plot_targets.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/engine/errors.hpp"
#include "src/io/input_file.hpp"

namespace sphk {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;

namespace {

std::vector<fs::path> snapshots_in(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("snap_") && name.ends_with(".hdf5")) found.push_back(entry.path());
  }
  std::ranges::sort(found);
  return found;
}

void require_rising(const char* option, double low, double high) {
  if (!(low < high))
    throw InputError(fmt::format("{} {:g},{:g}: the first number must be the smaller one", option, low, high));
}

}  // namespace

const std::string& FieldView::name() const {
  static const std::string density = "rho";
  return field.empty() ? density : field;
}

void FieldView::check() const {
  if (!range.empty()) require_rising("--range", range[0], range[1]);
  if (logarithmic && !range.empty() && !(range[0] > 0))
    throw InputError(fmt::format("--range {:g},{:g} with --log: both numbers must be above 0", range[0], range[1]));
  for (std::size_t k = 0; k < map.window.size(); k += 2)
    require_rising(k == 0 ? "--window: x" : "--window: y", map.window[k], map.window[k + 1]);
  if (map.slice && map.column)
    throw InputError("--slice shows a plane and --column the integral along z: give one of them");
}

Json FieldView::json() const {
  return {{"range", range.empty() ? Json(nullptr) : Json(range)}, {"log", logarithmic}};
}

bool PlotTargets::has_history() const {
  if (!fs::exists(history())) return false;
  require_file(history());
  return true;
}

std::optional<Problem> PlotTargets::problem() const {
  const fs::path scene_file = folder / "scene.used.toml";
  if (!fs::exists(scene_file)) return std::nullopt;
  return resolve_run(SceneFile(scene_file), snapshots.back());
}

PlotTargets find_targets(const fs::path& what, bool every) {
  if (fs::is_regular_file(what)) return {what, what.parent_path(), {what}, false};
  if (!fs::is_directory(what))
    throw InputError(
        fmt::format("{} is neither a run's folder nor a snapshot; `sphk run SCENE` makes a folder", what.string()));
  PlotTargets targets{what, what, snapshots_in(what), true};
  if (targets.snapshots.empty())
    throw InputError(
        fmt::format("{} holds no snapshots (snap_0000.hdf5, ...); is it the folder of a run?", what.string()));
  if (!every) targets.snapshots.erase(targets.snapshots.begin(), targets.snapshots.end() - 1);
  return targets;
}

void check_field(const FieldView& view, const PlotItem& item) {
  const std::vector<double> values = item.values(view.name());
  if (!view.logarithmic || !view.range.empty()) return;
  const double least = values.empty() ? 1 : std::ranges::min(values);
  if (!(least > 0))
    throw InputError(
        fmt::format("--log: {} is not positive everywhere in {} (the least is {:g}): leave --log out, or give a "
                    "range above 0 with --range LO,HI",
                    view.name(), item.json["file"].get<std::string>(), least));
}

void check_map(const FieldView& view, const PlotItem& item) {
  const std::string snapshot = item.json["file"];
  if (item.dimension() == 1)
    throw InputError(fmt::format("{} is one-dimensional: it has no map; --profile draws a field along x", snapshot));
  if (item.dimension() == 2 && (view.map.slice || view.map.column))
    throw InputError(
        fmt::format("{} is two-dimensional: --slice and --column are for gas in 3D, leave them out", snapshot));
  if (!item.has("rho") || !item.has("m"))
    throw InputError(
        fmt::format("{} holds no densities or masses, which maps need; snapshots of `sphk run` do", snapshot));
  check_field(view, item);
}

void require_same_units(const Json& items) {
  const auto units = [](const Json& item) { return item.contains("units") ? item["units"] : Json(); };
  const auto same = [&](const Json& item, const char* quantity) {
    const auto name = [&](const Json& of) { return of.is_null() ? Json() : of[quantity]; };
    return name(units(item)) == name(units(items.front()));
  };
  for (const Json& item : items)
    if (!same(item, "x") || !same(item, "m") || !same(item, "t"))
      throw InputError(fmt::format("{} and {} are in different units: draw them in a figure each",
                                   items.front()["file"].get<std::string>(), item["file"].get<std::string>()));
}

}  // namespace sphk
