#include "src/run/problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "src/engine/errors.hpp"
#include "src/run/file_scene.hpp"
#include "src/run/scene_file.hpp"
#include "src/scenes/initial_condition.hpp"
#include "src/schemes/labels.hpp"
#include "src/schemes/registry.hpp"

namespace sphk {

namespace {

bool is_initial_condition(const std::string& what) {
  return what.ends_with(".hdf5") || what.ends_with(".h5") || what.ends_with(".hdf") ||
         what.find('/') != std::string::npos || std::filesystem::is_regular_file(what);
}

/// Names the scene and declares every key.
void take_scene(Problem& problem, const Scene& scene) {
  problem.scene = &scene;
  declare_engine_keys(problem.settings);
  declare_run_keys(problem.settings);
  declare_initial_condition_keys(problem.settings);
  scene.declare(problem.settings);
}

void take_file(Problem& problem, const std::string& path) {
  problem.owned = std::make_unique<FileScene>(path);
  take_scene(problem, *problem.owned);
}

/// The scene that a scene file names, or the initial condition that its key scene.file names.
void take_scene_file(Problem& problem, const SceneFile& file) {
  const SceneFileEntry* entry = file.scene();
  const auto* name = entry ? std::get_if<std::string>(&entry->value) : nullptr;
  if (!entry)
    throw InputError(
        fmt::format("{}: no scene is named; begin the file with scene = \"sod\", or with name = \"sod\" "
                    "in the section [scene] (`sphk list` shows the names)",
                    file.path()));
  if (!name) throw InputError(file.message(*entry, "a scene's name is a string, such as \"sod\"", true));
  if (*name == FileScene::scene_name) {
    const std::string* path = file.text("scene.file");
    if (!path) throw InputError(file.message(*entry, "the scene \"file\" needs scene.file = \"PATH.hdf5\"", true));
    return take_file(problem, *path);
  }
  try {
    take_scene(problem, find_scene(*name));
  } catch (const InputError& error) {
    throw InputError(file.message(*entry, error.what(), true));
  }
}

/// The overrides with a paper's label in place of a scheme taken apart, before the others: those may change its parts.
std::vector<Override> with_labels(const std::vector<Override>& overrides) {
  std::vector<Override> keys, others;
  for (const Override& change : overrides) {
    const auto label = change.name == "sph.scheme" ? keys_of_label(change.text) : std::nullopt;
    if (!label) {
      others.push_back(change);
      continue;
    }
    for (const auto& [name, text] : *label) keys.push_back({name, text, change.spelling});
  }
  keys.insert(keys.end(), others.begin(), others.end());
  return keys;
}

std::vector<std::string> apply_overrides(Settings& settings, const std::vector<Override>& overrides) {
  std::vector<std::string> problems;
  for (const Override& change : with_labels(overrides)) {
    try {
      settings.set_from_text(change.name, change.text, Origin::command_line);
    } catch (const InputError& error) {
      problems.push_back(fmt::format("{}: {}", change.spelling, error.what()));
    }
  }
  return problems;
}

}  // namespace

std::vector<Override> overrides_of(const KeyTexts& keys) {
  std::vector<Override> overrides;
  for (const auto& [key, text] : keys) overrides.push_back({key, text, key + "=" + text});
  return overrides;
}

void declare_run_keys(Settings& settings) {
  settings.declare({.name = "time.end", .value = 1.0, .doc = "end time, code units", .choices = {}});
  settings.declare({.name = "time.max_steps",
                    .value = std::int64_t{0},
                    .doc = "stop after so many steps; 0: no limit",
                    .choices = {},
                    .min = 0});
  settings.declare({.name = "output.snapshots",
                    .value = std::int64_t{10},
                    .doc = "snapshots after the first, at equal intervals of time",
                    .choices = {},
                    .min = 1,
                    .max = 9999});
  settings.declare({.name = "output.errors",
                    .value = false,
                    .doc = "E0, R, V (R10 eq 28-30) and nearest neighbours into the snapshots, their budget into the "
                           "history and the final table",
                    .choices = {}});
  settings.declare({.name = "output.checkpoint",
                    .value = 600.0,
                    .doc = "wall-clock seconds between checkpoints; 0: only when the run is stopped",
                    .choices = {},
                    .min = 0});
  settings.declare({.name = "output.compression",
                    .value = std::string("none"),
                    .doc = "of the snapshots; gzip: smaller, and slower to write",
                    .choices = {"none", "gzip"}});
}

bool may_change(const std::string& key) {
  return key == "time.end" || key == "time.max_steps" || key.starts_with("output.");
}

void adapt(Problem& problem) {
  for (int twice = 0; twice < 2; ++twice) {  // a scene's choices may follow from the method, as that does from them
    problem.scene->adapt(problem.settings);
    adopt_scheme(problem.settings, problem.scene->dimension(problem.settings), problem.scene->mixes());
  }
}

Problem resolve_problem(const std::string& what, const std::vector<Override>& overrides) {
  Problem problem;
  std::vector<std::string> problems;
  if (what.ends_with(".toml")) {
    const SceneFile file(what);
    take_scene_file(problem, file);
    problems = file.apply(problem.settings);
  } else if (is_initial_condition(what)) {
    take_file(problem, what);
  } else {
    take_scene(problem, find_scene(what));
  }
  for (auto& message : apply_overrides(problem.settings, overrides)) problems.push_back(std::move(message));
  if (!problems.empty()) throw InputError(fmt::format("{}", fmt::join(problems, "\n")));
  adapt(problem);
  return problem;
}

Settings with_lattice(const Settings& settings) {
  Settings copy = settings;
  const auto key = std::ranges::find(copy.keys(), "scene.lattice", &Key::name);
  if (key != copy.keys().end() && std::ranges::find(key->choices, "cubic") != key->choices.end())
    copy.set("scene.lattice", std::string("cubic"), Origin::scene);
  return copy;
}

}  // namespace sphk
