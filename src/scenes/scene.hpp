// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "src/engine/particle_set.hpp"
#include "src/engine/settings.hpp"
#include "src/engine/simulation.hpp"

namespace sphk {

/// Gas state of an exact solution at one place and time.
struct GasState {
  double rho = 0;
  Array3 v{};
  double P = 0;
  /// Specific thermal energy of an ideal gas.
  double u(double gamma) const { return P / ((gamma - 1) * rho); }
};

/// The rows of a field of vectors, which are those of the field.
std::span<const Array3> rows(const Field& field);

/// One error norm: mean |error| (l1), root mean square (l2), largest (linf) and where the largest sits.
struct ErrorNorm {
  double l1 = 0, l2 = 0, linf = 0;
  Array3 where{};
};

/// The gas at a place and time.
using ExactSolution = std::function<GasState(const Array3& x, double t)>;
/// By field name: "v", "rho", "P", "v_centres", "v_particles", ... (norms.hpp)
using Errors = std::map<std::string, ErrorNorm>;
/// Columns of history.csv by name.
using Measures = std::vector<std::pair<std::string, double>>;

/// What converged runs of other methods give for a measure at a time: a value between `low` and `high`.
struct Reference {
  std::string measure;  ///< a name of Scene::measures
  double time = 0, low = 0, high = 0;
  bool over_start = false;  ///< of the measure over its value at the start
};

/// What a paper has where a scene of it has something else by default.
struct PaperChoice {
  std::string paper;                ///< such as "R10: 256 particles along the box"
  std::vector<std::string> keys{};  ///< that bring it, as for --set; none: nothing does
};

/// How `sphk plot` draws a scene: against which coordinate, which fields, over which range.
struct PlotHint {
  std::string abscissa = "x";  ///< x | y | R (cylindrical) | r (spherical)
  std::vector<std::string> fields{"rho", "v", "P"};
  double from = 0, to = 1;
  Array3 centre{};    ///< at t = 0
  Array3 velocity{};  ///< of the centre; the pictures' velocities are relative to it
  bool map = false;   ///< also a slice through the density; always drawn in 2D and around a centre
};

/// How `sphk gallery` shows a scene: by a run that takes a few seconds on a laptop.
struct GalleryTile {
  std::vector<std::string> keys{};  ///< what makes the run small, as for --set
  /// Drawn along the abscissa, beside the exact solution; "": a map of the density. By default rho, or a map where the
  /// plot hint asks for one.
  std::optional<std::string> field{};
};

/// A named test problem: defaults, initial condition, exact solution, what it measures.
class Scene {
 public:
  virtual ~Scene() = default;
  virtual std::string name() const = 0;
  /// One line for `sphk list`.
  virtual std::string summary() const = 0;
  /// Declares the keys of [scene] and prefers the engine keys that suit it (scheme, kernel, neighbours, gamma,
  /// time.end).
  virtual void declare(Settings& settings) const = 0;
  /// Called after the file and the command line have set their keys, and again once scheme, kernel and neighbours are
  /// chosen: prefers values that follow from them, such as gamma from scene.variant. Keys that the user set stay as
  /// they are. A kernel and neighbour number that a scene prefers hold under the scheme that it prefers.
  virtual void adapt(Settings&) const {}
  /// Dimensions of the gas: by default scene.dimension, or 3 where there is no such key.
  virtual int dimension(const Settings& settings) const;
  /// Whether gases of unlike entropies mix: some schemes then do better with u integrated.
  virtual bool mixes() const { return false; }
  virtual ParticleSet build(const Settings& settings) const = 0;
  /// Velocities that depend on where the particles are, once they have settled elsewhere (initial_condition.hpp); by
  /// default particles keep theirs.
  virtual void set_velocities(ParticleSet&, const Settings&) const {}
  /// Heat that the gas takes in during the run, in the order of times.
  virtual std::vector<HeatEvent> heatings(const Settings&) const { return {}; }
  /// The exact solution, if there is one.
  virtual ExactSolution exact(const Settings&) const { return {}; }
  /// The paper's norm and its kin (norms.hpp); empty: no reference.
  virtual Errors errors(const Settings&, const Snapshot&) const { return {}; }
  /// The scene's own columns of history.csv.
  virtual Measures measures(const Settings&, const Snapshot&) const { return {}; }
  /// What the measures should be; empty: unknown for these settings.
  virtual std::vector<Reference> references(const Settings&) const { return {}; }
  /// The keys, as for --set, with which there are some where there are none without; empty: none help.
  virtual std::string keys_with_references() const { return ""; }
  /// The choices of the paper that the scene is from, for these settings, whether or not they are made (problem.hpp).
  virtual std::vector<PaperChoice> paper(const Settings&) const { return {}; }
  virtual PlotHint plot_hint(const Settings&) const { return {}; }
  /// By default a run of the scene as it is.
  virtual GalleryTile gallery() const { return {}; }
};

/// Every scene, in the order of `sphk list`.
const std::vector<const Scene*>& scenes();
/// The scene of that name; throws InputError with the nearest name.
const Scene& find_scene(const std::string& name);

}  // namespace sphk
