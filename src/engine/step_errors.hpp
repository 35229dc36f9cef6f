// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "src/engine/errors.hpp"
#include "src/engine/particle_set.hpp"

namespace sphk {

/// The particle that asks for the shortest time-step, where a run cannot go on with it.
struct StuckParticle {
  std::uint64_t id = 0;
  Array3 x{};
  double time = 0;
  long step = 0;
  double dt = 0;        ///< what it asks for
  double shortest = 0;  ///< step of the hierarchy
};

enum class StuckReason {
  not_finite,       ///< the next time-step is not a positive number
  no_progress,      ///< a step of dt does not change the time
  below_the_ticks,  ///< it asks for less than the shortest step of the hierarchy
};

/// Names the particle and the remedy.
struct StuckError : NumericsError {
  StuckReason reason;
  StuckParticle particle;
  StuckError(StuckReason why, const StuckParticle& stuck);
};

}  // namespace sphk
