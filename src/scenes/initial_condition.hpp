// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/scenes/scene.hpp"

namespace sphk {

/// Keys of the section [ic]: ic.pressure, ic.relax and ic.rounds.
void declare_initial_condition_keys(Settings& settings);

/// The scene's particles as a run takes them. With ic.pressure > 0 every u follows from that pressure and the density
/// that the run's smoothing kernel measures (V10 sec 4.2). With ic.relax > 0 the gas then settles for that time, from
/// rest, under V10's scheme with u changed by viscosity and conductivity alone, not by work, so that it keeps close to
/// its profile (V10 sec 4.5.1); after it the scene sets its velocities anew. With ic.rounds > 1 it settles in that many
/// parts, each from rest, and u follows from ic.pressure again after each: what is left is an arrangement that is at
/// rest with even pressure, also where particles of unlike masses meet. Throws InputError.
ParticleSet initial_condition(const Scene& scene, const Settings& settings);

/// Where scene.temperatures is "smoothed": u = P / ((gamma - 1) rho) with the density that the run's own smoothing
/// kernel measures, in place of the exact one, so that P is even across a step of density as well (S12 sec 7.5, R10 sec
/// 5.1 and Appendix B; R10 leaves its relative-temperature schemes exact). Needs the engine's keys.
void smooth_temperatures(ParticleSet& gas, double P, const Settings& settings);

}  // namespace sphk
