// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/engine/simulation.hpp"

namespace sphk {

/// Throws InputError, naming the first particle and the remedy, for what no scheme can run: no particles, masses that
/// are not positive, energies that are negative, anything that is not finite, positions outside an open or periodic box
/// by more than its size, lists of different lengths.
void check_runnable(const ParticleSet& particles);

/// Throws InputError for settings that no run of these particles can meet, such as fewer neighbours than the self term
/// counts (`self_term`).
void check_runnable(const SimulationSettings& settings, const ParticleSet& particles, double self_term);

}  // namespace sphk
