#pragma once

#include "kernels/passes/step_passes.hpp"
#include "src/engine/host_columns.hpp"
#include "src/engine/particle_set.hpp"
#include "src/engine/simulation.hpp"

namespace sphk {

// What needs the fields that every scheme has, and no more: L is a BaseLayout. Compiled once a dimension and thermal
// variable (base_1d.cpp and so on), from the definitions in base_code.hpp.

template <int D>
using CountColumns = Columns<D, List<NeighbourCount>>;

/// Copies particles to the columns, with their specific energies as thermal variable.
template <class L>
void copy_to_columns(const Particles<L>& state, const ParticleSet& particles);

/// First support radii from the volumes of the cells where none are given: the searches start near their ends.
/// `fallback` where a cell has no volume.
template <class L>
void guess_supports(const Particles<L>& state, double fallback);

/// Turns the loaded specific energies into the scheme's thermal variable, with the standard density.
template <class L>
void thermal_from_energy(const Particles<L>& state);

/// Room for steps of the particles' own; all of them are at the start of a block.
template <class L>
void allow_individual_steps(Particles<L>& state, Schedule& schedule, const SimulationSettings& settings);

/// True neighbours, r < h_i, self included: into `counts`, and their minimum, mean and maximum into the report.
template <class L>
void count_neighbours(const Particles<L>& particles, const CountColumns<L::dimension>& counts, StepReport& report);

/// Conserved sums and extremes. Positions are those of the run: in a periodic box angular momentum is about its origin
/// and jumps when a particle is wrapped.
template <class L>
Totals totals(const Particles<L>& state);

/// The state on the host, sorted by id, positions wrapped into the box.
template <class L>
Snapshot base_snapshot(const Particles<L>& particles, const HostColumns<L>& host, const Box& box, double time,
                       long step);

/// Where particle i sits, into the report as what limits the time-step.
template <class L>
void note_limiting_particle(const Particles<L>& state, int i, StepReport& report);

}  // namespace sphk
