// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "src/engine/settings.hpp"
#include "src/run/scene_file.hpp"
#include "src/scenes/scene.hpp"

namespace sphk {

/// A key set on the command line: `spelling` is what the user typed ("--set sph.kernel=cs", "--kernel cs").
struct Override {
  std::string name, text, spelling;
};

/// Keys and what each is set to, as text.
using KeyTexts = std::vector<std::pair<std::string, std::string>>;
/// The keys without those that come again, with other texts, later.
KeyTexts last_of_each(const KeyTexts& keys);
std::vector<Override> overrides_of(const KeyTexts& keys);

/// What to compute: a scene and its complete settings.
struct Problem {
  const Scene* scene = nullptr;
  std::unique_ptr<Scene> owned;  ///< keeps the scene of an initial-condition file alive
  Settings settings;
};

/// Declares the keys of the sections [units], [time] and [output] that a run reads.
void declare_run_keys(Settings& settings);

/// Whether a key may change when a run goes on: where it ends and what it leaves, not what it computes.
bool may_change(const std::string& key);

/// Scene, scheme, dimension and what the user has set, brought together: what is left open becomes the scene's choice,
/// or the scheme's. Throws InputError for keys that the scheme does not have.
void adapt(Problem& problem);

/// The choices of the scene's paper that the problem does not make.
std::vector<PaperChoice> departures(const Problem& problem);

/// Sentences on the known limits that the problem's gas, as it starts, and its settings meet.
std::vector<std::string> limits_met(const Problem& problem, const ParticleSet& gas);

/// `what`: a scene's name, a scene file (*.toml) or an initial condition (an HDF5 file). A scene file may name an
/// initial condition, by its path from the scene file's folder. Throws one InputError that lists every unknown key,
/// wrong type and value out of range of the file and of the overrides.
Problem resolve_problem(const std::string& what, const std::vector<Override>& overrides);

/// The same of a scene that is in no list.
Problem resolve_problem(std::unique_ptr<Scene> scene, const std::vector<Override>& overrides);

/// The problem of a run by its scene file. Where the initial condition that it names is gone, the particles of
/// `snapshot`, one of the run's, stand in for it. Throws InputError.
Problem resolve_run(const SceneFile& file, const std::filesystem::path& snapshot);

/// What is to be said of the file that a problem begins with, and of its units.
std::vector<std::string> input_remarks(const Problem& problem);

/// A copy of the settings with the scene's cheapest arrangement of particles (a lattice, where it offers one, and
/// temperatures that need no density), for commands that only need their number and state.
Settings with_lattice(const Settings& settings);

}  // namespace sphk
