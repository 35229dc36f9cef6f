// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "kernels/passes/step_passes.hpp"
#include "src/engine/field_places.hpp"
#include "src/engine/particle_set.hpp"
#include "src/engine/simulation.hpp"

namespace sphk {

// What a run and the scheme that it follows know of each other. A run needs the fields that every scheme has, and no
// more: L is a BaseLayout here, and the code of runs is compiled once a dimension and thermal variable.

/// A pass of a step, for code that does not know its type.
struct PassFacts {
  const char* name;
  bool (*wanted)(const Given&);  ///< whether a run with these numbers has it
};

/// What a run must know of the compiled scheme that it follows.
struct CompiledFacts {
  bool mixed = false;
  std::span<const FieldPlace> fields;  ///< of the columns
  int rows = 0;                        ///< of the columns
  int alpha_row = -1;                  ///< of the switch, which initial conditions may set; -1: there is none
  int state_density_row = 0;           ///< of the columns: the density of the equations of motion
  int support_pass = 0;                ///< the place of the search for support radii in a step
  int density_pass = 0;                ///< and of the pass that computes the density of the equations of motion
  std::vector<PassFacts> passes;       ///< in the order of a step
  double bytes_per_particle = 0, flops_per_pair = 0;
  double (*stiffness)(const Given&) = nullptr;  ///< of the recipe (recipe.hpp)
};

/// The passes of a scheme: the part of a run that knows its fields, smoothing kernel and pair arithmetic.
template <class L>
class SchemePasses {
 public:
  const CompiledFacts facts;
  explicit SchemePasses(CompiledFacts of) : facts(std::move(of)) {}
  virtual ~SchemePasses() = default;
  virtual void run(int pass, Run<L>& run) const = 0;
  /// Predicts all of sleeping particles to the present time, where until now only their positions were.
  virtual void predict(const Run<L>& run) const = 0;
  /// One right-hand side, as `sphk rates` writes it; the passes have just been run.
  virtual std::vector<Field> rates(const Run<L>& run, bool split) const = 0;
  /// What Simulation::errors gives.
  virtual std::vector<Field> errors(const Particles<L>& particles) const = 0;
};

/// Particles on the device, sorted, with supports, densities and the thermal variable; `find_supports` runs the pass
/// that searches for supports. Defined in load_run.hpp.
template <class L>
Run<L> load_run(const ParticleSet& particles, const SimulationSettings& settings, const CompiledFacts& facts,
                const std::function<void(Run<L>&)>& find_supports);

/// A run of a scheme. Defined in engine.hpp.
template <class L>
std::unique_ptr<Simulation> make_run(const ParticleSet& particles, const SimulationSettings& settings,
                                     std::unique_ptr<SchemePasses<L>> passes);

}  // namespace sphk
