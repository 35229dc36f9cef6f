// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>

#include "src/engine/errors.hpp"
#include "src/run/file_scene.hpp"
#include "src/run/unit_keys.hpp"
#include "src/scenes/initial_condition.hpp"
#include "src/schemes/labels.hpp"
#include "src/schemes/registry.hpp"
#include "src/stability/limits.hpp"

namespace sphk {

namespace {

namespace fs = std::filesystem;

bool has_hdf5_name(const std::string& what) {
  return what.ends_with(".hdf5") || what.ends_with(".h5") || what.ends_with(".hdf");
}

bool is_initial_condition(const std::string& what) {
  return has_hdf5_name(what) || what.find('/') != std::string::npos || fs::is_regular_file(what);
}

/// Names the scene and declares every key.
void take_scene(Problem& problem, const Scene& scene) {
  problem.scene = &scene;
  declare_engine_keys(problem.settings);
  declare_run_keys(problem.settings);
  declare_initial_condition_keys(problem.settings);
  scene.declare(problem.settings);
}

/// `stand_in`: whose particles are taken where the file is gone; empty: none.
void take_file(Problem& problem, const fs::path& path, const fs::path& stand_in) {
  const bool gone = !stand_in.empty() && !fs::exists(path);
  problem.owned = std::make_unique<FileScene>(path, gone ? stand_in : path);
  take_scene(problem, *problem.owned);
}

/// The scene that a scene file names, or the initial condition that its key scene.file names.
void take_scene_file(Problem& problem, const SceneFile& file, const fs::path& stand_in) {
  const SceneFileEntry* entry = file.scene();
  const auto* name = entry ? std::get_if<std::string>(&entry->value) : nullptr;
  if (!entry)
    throw InputError(
        fmt::format("{}: no scene is named; begin the file with scene = \"sod\", or with name = \"sod\" "
                    "in the section [scene] (`sphk list` shows the names)",
                    file.path()));
  if (!name) throw InputError(file.message(*entry, "a scene's name is a string, such as \"sod\"", true));
  const fs::path beside = fs::path(file.path()).parent_path();
  if (has_hdf5_name(*name)) return take_file(problem, beside / *name, stand_in);
  if (*name == FileScene::scene_name) {
    const std::string* path = file.text("scene.file");
    if (!path) throw InputError(file.message(*entry, "the scene \"file\" needs scene.file = \"PATH.hdf5\"", true));
    return take_file(problem, beside / *path, stand_in);
  }
  try {
    take_scene(problem, find_scene(*name));
  } catch (const InputError& error) {
    throw InputError(file.message(*entry, error.what(), true));
  }
}

/// Takes the scene and the keys of a scene file; returns what is wrong with these.
std::vector<std::string> take_all(Problem& problem, const SceneFile& file, const fs::path& stand_in = {}) {
  take_scene_file(problem, file, stand_in);
  const std::optional<std::string> path =
      problem.settings.has("scene.file") ? std::optional(problem.settings.text("scene.file")) : std::nullopt;
  std::vector<std::string> problems = file.apply(problem.settings);
  if (path) problem.settings.set("scene.file", *path, Origin::file);  // where it lies, wherever a run goes on
  return problems;
}

/// "WC2-100": a kernel with its neighbours, as papers write.
std::optional<KeyValues> kernel_and_neighbours(const std::string& text) {
  const auto dash = text.rfind('-');
  if (dash == std::string::npos || dash + 1 == text.size()) return std::nullopt;
  if (text.find_first_not_of("0123456789", dash + 1) != std::string::npos) return std::nullopt;
  return KeyValues{{"sph.kernel", text.substr(0, dash)}, {"sph.neighbours", text.substr(dash + 1)}};
}

/// What is wrong with keys that are set twice, or that a command line cannot set.
std::vector<std::string> clashes(const std::vector<Override>& overrides) {
  std::vector<std::string> problems;
  for (auto change = overrides.begin(); change != overrides.end(); ++change) {
    const auto earlier =
        std::find_if(overrides.begin(), change, [&](const Override& other) { return other.name == change->name; });
    if (earlier != change)
      problems.push_back(
          fmt::format("{} and {} both set {}: give one of them", earlier->spelling, change->spelling, change->name));
    if (change->name == "scene.file")
      problems.push_back(
          fmt::format("{}: name the file in place of the scene, as in sphk run {}", change->spelling, change->text));
  }
  return problems;
}

/// Kernels are known in any case.
void lower_kernel(Settings& settings) {
  const auto key = std::ranges::find(settings.keys(), "sph.kernel", &Key::name);
  std::string name = std::get<std::string>(key->value);
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
  settings.set("sph.kernel", name, Origin{key->origin});
}

/// The overrides with a paper's label in place of a scheme or kernel taken apart, before the others: those may change
/// its parts.
std::vector<Override> with_labels(const std::vector<Override>& overrides) {
  std::vector<Override> keys, others;
  for (const Override& change : overrides) {
    const auto label = change.name == "sph.scheme"   ? keys_of_label(change.text)
                       : change.name == "sph.kernel" ? kernel_and_neighbours(change.text)
                                                     : std::nullopt;
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
      checked_unit(change.name, change.text);
    } catch (const InputError& error) {
      problems.push_back(fmt::format("{}: {}", change.spelling, error.what()));
    }
  }
  return problems;
}

/// Brings what was set together, or tells all that is wrong with it.
void finish(Problem& problem, const std::vector<std::string>& problems) {
  if (!problems.empty()) throw InputError(fmt::format("{}", fmt::join(problems, "\n")));
  lower_kernel(problem.settings);
  settle_units(problem.settings);
  adapt(problem);
}

void finish(Problem& problem, std::vector<std::string> problems, const std::vector<Override>& overrides) {
  std::ranges::move(clashes(overrides), std::back_inserter(problems));
  std::ranges::move(apply_overrides(problem.settings, overrides), std::back_inserter(problems));
  finish(problem, problems);
}

/// Do the settings say what "key=value" would? A label says what each of its keys does.
bool has_as(const Settings& settings, const std::string& text) {
  const auto equals = text.find('=');
  Settings wanted = settings;
  if (!apply_overrides(wanted, overrides_of({{text.substr(0, equals), text.substr(equals + 1)}})).empty()) return false;
  return std::ranges::equal(wanted.keys(), settings.keys(), {}, &Key::value, &Key::value);
}

}  // namespace

KeyTexts last_of_each(const KeyTexts& keys) {
  KeyTexts last;
  for (const auto& entry : keys) {
    std::erase_if(last, [&](const auto& other) { return other.first == entry.first; });
    last.push_back(entry);
  }
  return last;
}

std::vector<Override> overrides_of(const KeyTexts& keys) {
  std::vector<Override> overrides;
  for (const auto& [key, text] : last_of_each(keys)) overrides.push_back({key, text, key + "=" + text});
  return overrides;
}

void declare_run_keys(Settings& settings) {
  declare_unit_keys(settings);
  settings.declare({.name = "time.end", .value = 1.0, .doc = "end time, code units", .choices = {}});
  settings.declare({.name = "time.max_steps",
                    .value = std::int64_t{-1},
                    .doc = "stop after so many steps; -1: no limit",
                    .choices = {},
                    .min = -1});
  settings.declare({.name = "time.max_drift",
                    .value = 1.0,
                    .doc = "share of its energy that a run may gain or lose; beyond that it fails (exit code 3)",
                    .choices = {},
                    .min = 0,
                    .max = 1e300});
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
  return key == "time.end" || key == "time.max_steps" || key == "time.max_drift" || key.starts_with("output.");
}

void adapt(Problem& problem) {
  for (int twice = 0; twice < 2; ++twice) {  // a scene's choices may follow from the method, as that does from them
    problem.scene->adapt(problem.settings);
    adopt_scheme(problem.settings, problem.scene->dimension(problem.settings), problem.scene->mixes());
  }
}

std::vector<PaperChoice> departures(const Problem& problem) {
  std::vector<PaperChoice> choices = problem.scene->paper(problem.settings);
  std::erase_if(choices, [&](const PaperChoice& choice) {
    return !choice.keys.empty() &&
           std::ranges::all_of(choice.keys, [&](const std::string& key) { return has_as(problem.settings, key); });
  });
  return choices;
}

std::vector<std::string> limits_met(const Problem& problem, const ParticleSet& gas) {
  const Settings& s = problem.settings;
  Method method{s.text("sph.scheme"), s.text("sph.energy")};
  if (s.has("conductivity.signal") && s.real("conductivity.alpha") > 0) method.signal = s.text("conductivity.signal");
  method.motion = !s.has("time.motion") || s.flag("time.motion");
  return limit_remarks(contrasts(gas), method);
}

Problem resolve_problem(const std::string& what, const std::vector<Override>& overrides) {
  Problem problem;
  std::vector<std::string> problems;
  if (what.ends_with(".toml")) {
    problems = take_all(problem, SceneFile(what));
  } else if (is_initial_condition(what)) {
    take_file(problem, what, {});
  } else {
    take_scene(problem, find_scene(what));
  }
  finish(problem, std::move(problems), overrides);
  return problem;
}

Problem resolve_problem(std::unique_ptr<Scene> scene, const std::vector<Override>& overrides) {
  Problem problem;
  problem.owned = std::move(scene);
  take_scene(problem, *problem.owned);
  finish(problem, {}, overrides);
  return problem;
}

Problem resolve_run(const SceneFile& file, const fs::path& snapshot) {
  Problem problem;
  const std::vector<std::string> problems = take_all(problem, file, snapshot);
  finish(problem, problems);
  return problem;
}

std::vector<std::string> input_remarks(const Problem& problem) {
  const auto* file = dynamic_cast<const FileScene*>(problem.scene);
  std::vector<std::string> remarks;
  if (file) remarks = file->remarks();
  for (auto& remark : unit_remarks(units_of(problem.settings), file ? file->units() : std::nullopt))
    remarks.push_back(std::move(remark));
  return remarks;
}

Settings with_lattice(const Settings& settings) {
  Settings copy = settings;
  const auto key = std::ranges::find(copy.keys(), "scene.lattice", &Key::name);
  if (key != copy.keys().end() && std::ranges::find(key->choices, "cubic") != key->choices.end())
    copy.set("scene.lattice", std::string("cubic"), Origin::scene);
  const auto temperatures = std::ranges::find(copy.keys(), "scene.temperatures", &Key::name);
  if (temperatures != copy.keys().end()) copy.set("scene.temperatures", std::string("exact"), Origin::scene);
  return copy;
}

}  // namespace sphk
