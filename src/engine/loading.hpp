// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/state.hpp"
#include "src/engine/simulation.hpp"

namespace sphk {

/// The support radius if the particles filled their box evenly.
double support_of_even_gas(const ParticleSet& particles, const SimulationSettings& settings);

/// Largest support radius that a gas can need: the box's diagonal where an axis is open; in a periodic box what the
/// N_n-th image is nearer than wherever the particles are.
double support_cap(const ParticleSet& particles, const SimulationSettings& settings);

/// The numbers that passes and terms read: those of the settings, with what every scheme has.
Given given_of(const SimulationSettings& settings);
bool has_own_steps(const SimulationSettings& settings);
/// In the run's own units.
Parameters parameters_of(const ParticleSet& particles, const SimulationSettings& settings);

}  // namespace sphk
