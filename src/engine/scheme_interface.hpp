#pragma once

#include <functional>

#include "kernels/passes/step_passes.hpp"
#include "src/engine/particle_set.hpp"
#include "src/engine/simulation.hpp"

namespace sphk {

// What a run and the scheme that it follows know of each other. A run needs the fields that every scheme has, and no
// more: L is a BaseLayout here, and the code of runs is compiled once a dimension and thermal variable.

/// A column that snapshots show beside those of every scheme: one number a particle.
struct ShownColumn {
  const char *name, *description;
  UnitExponents units;
  int row;
};

/// What a run must know of a scheme.
struct SchemeFacts {
  bool mixed = false;
  int rows = 0;                     ///< of the columns
  int alpha_row = -1;               ///< of the switch, which initial conditions may set; -1: there is none
  int state_density_row = 0;        ///< of the columns: the density of the equations of motion
  int support_pass = 0;             ///< the place of the search for support radii in a step
  std::vector<const char*> passes;  ///< names, in the order of a step
  std::vector<ShownColumn> shown;
  double bytes_per_particle = 0, flops_per_pair = 0;
};

/// The passes of a scheme: the part of a run that knows its fields, smoothing kernel and pair arithmetic.
template <class L>
class SchemePasses {
 public:
  const SchemeFacts facts;
  explicit SchemePasses(SchemeFacts of) : facts(std::move(of)) {}
  virtual ~SchemePasses() = default;
  virtual void run(int pass, Run<L>& run) const = 0;
  /// One right-hand side, as `sphk rates` writes it; the passes have just been run. In double alone.
  virtual std::vector<Field> rates(const Particles<L>& particles, bool split) const = 0;
  /// What Simulation::errors gives.
  virtual std::vector<Field> errors(const Particles<L>& particles) const = 0;
};

/// Particles on the device, sorted, with supports, densities and the thermal variable; `find_supports` runs the pass
/// that searches for supports. Defined in load_run.hpp.
template <class L>
Run<L> load_run(const ParticleSet& particles, const SimulationSettings& settings, const SchemeFacts& facts,
                const std::function<void(Run<L>&)>& find_supports);

/// A run of a scheme. Defined in engine.hpp.
template <class L>
std::unique_ptr<Simulation> make_run(const ParticleSet& particles, const SimulationSettings& settings,
                                     std::unique_ptr<SchemePasses<L>> passes);

}  // namespace sphk
