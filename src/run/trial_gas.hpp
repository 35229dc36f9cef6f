// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/scenes/scene.hpp"

namespace sphk {

/// Gas like that of a scene, but few particles of it: for what wants to be known before all are there.
struct TrialGas {
  ParticleSet gas;
  double particles = 0;   ///< of the whole
  double refinement = 1;  ///< the mean distance of particles here over that in the whole
};

/// One of each k particles, k times as heavy.
ParticleSet thinned(const ParticleSet& gas, std::size_t k);

/// A scene's own gas at a coarser scene.n, whose count and another's at half of it tell how the whole one grows (exact
/// but for rounding); of a file every k-th particle, k times as heavy. All particles where they are few.
TrialGas trial_gas(const Scene& scene, const Settings& settings);

/// Throws std::runtime_error where the scene's gas and its run would take more memory than this machine can give,
/// before any of it is taken. A file's gas is not looked at.
void require_memory(const Scene& scene, const Settings& settings);
/// The same where there are so many particles, of so many bytes each.
void require_memory(double particles, double bytes_per_particle);

}  // namespace sphk
