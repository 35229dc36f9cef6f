// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/step_errors.hpp"

#include <fmt/format.h>

namespace sphk {

namespace {

std::string problem_of(StuckReason reason, const StuckParticle& p) {
  switch (reason) {
    case StuckReason::no_progress:
      return fmt::format("asks for a time-step of {:.3g}, too short to change the time", p.dt);
    case StuckReason::below_the_ticks:
      return fmt::format(
          "asks for a time-step of {:.3g}, below the shortest one, {:.3g}, which is 1e-13 of the time between two "
          "snapshots",
          p.dt, p.shortest);
    default:
      return "asks for a time-step C h / v_sig that is not a positive number: a velocity, an energy or a density of it "
             "or of a neighbour is not finite, or too large for the pair arithmetic";
  }
}

const char* remedy_of(StuckReason reason) {
  switch (reason) {
    case StuckReason::no_progress:
      return "is a velocity or an energy there in other units? A smaller time.courant may help";
    case StuckReason::below_the_ticks:
      return "more snapshots (output.snapshots) allow shorter steps";
    default:
      return "sph.precision = \"double\" holds larger numbers, a smaller time.courant may help";
  }
}

}  // namespace

StuckError::StuckError(StuckReason why, const StuckParticle& p)
    : NumericsError(fmt::format("step {}, t = {}: the particle with id {} at ({:.6g}, {:.6g}, {:.6g}) {}. Look at the "
                                "gas around it; {}.",
                                p.step, p.time, p.id, p.x[0], p.x[1], p.x[2], problem_of(why, p), remedy_of(why))),
      reason(why),
      particle(p) {}

}  // namespace sphk
