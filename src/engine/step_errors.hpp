#pragma once

#include <cstdint>

#include "src/engine/particle_set.hpp"

namespace sphk {

/// The particle that asks for the shortest time-step, where a run cannot go on with it.
struct StuckParticle {
  std::uint64_t id = 0;
  Array3 x{};
  double time = 0;
  long step = 0;
};

/// NumericsErrors that name the particle and the remedy. The next time-step is not a positive number;
[[noreturn]] void fail_not_finite(const StuckParticle& particle);
/// a step of dt does not change the time;
[[noreturn]] void fail_without_progress(const StuckParticle& particle, double dt);
/// it asks for less than the shortest step of the hierarchy.
[[noreturn]] void fail_below_shortest(const StuckParticle& particle, double dt, double shortest);

}  // namespace sphk
