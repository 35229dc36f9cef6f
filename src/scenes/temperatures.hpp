#pragma once

#include "src/engine/particle_set.hpp"
#include "src/engine/settings.hpp"

namespace sphk {

/// scene.temperatures: exact | smoothed.
void declare_temperatures(Settings& settings);

/// u = P / ((gamma - 1) rho) with the density that the run's own smoothing kernel measures. Needs the engine's keys.
void set_pressure(ParticleSet& gas, double P, const Settings& settings);

/// Where scene.temperatures is "smoothed": u = P / ((gamma - 1) rho) with the density that the run's own smoothing
/// kernel measures, in place of the exact one, so that P is even across a step of density as well (S12 sec 7.5, R10 sec
/// 5.1 and Appendix B; R10 leaves its relative-temperature schemes exact). Needs the engine's keys.
void smooth_temperatures(ParticleSet& gas, double P, const Settings& settings);

}  // namespace sphk
