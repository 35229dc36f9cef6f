#pragma once

#include "src/engine/particle_set.hpp"
#include "src/engine/settings.hpp"

namespace sphk {

/// scene.relax: how long an initial condition rests before a run.
void declare_relaxation(Settings& settings);

/// Lets the gas settle for the time of scene.relax, from rest: V10's scheme with u changed by viscosity and
/// conductivity alone, not by work, so that it keeps close to its profile (V10 sec 4.5.1). Positions and u change;
/// velocities stay those that the particles had. False where that time is 0. Needs the engine's keys.
bool relax(ParticleSet& gas, const Settings& settings);

}  // namespace sphk
