#include "src/engine/step_errors.hpp"

#include <fmt/format.h>

#include "src/engine/errors.hpp"

namespace sphk {

namespace {

[[noreturn]] void fail(const StuckParticle& p, const std::string& problem, const char* remedy) {
  throw NumericsError(
      fmt::format("step {}, t = {}: the particle with id {} at ({:.6g}, {:.6g}, {:.6g}) {}. Look at the "
                  "gas around it; {}.",
                  p.step, p.time, p.id, p.x[0], p.x[1], p.x[2], problem, remedy));
}

}  // namespace

void fail_not_finite(const StuckParticle& particle) {
  fail(particle,
       "asks for a time-step C h / v_sig that is not a positive number: a velocity, an energy or a density of it or of "
       "a neighbour is not finite, or too large for the pair arithmetic",
       "sph.precision = \"double\" holds larger numbers, a smaller time.courant may help");
}

void fail_without_progress(const StuckParticle& particle, double dt) {
  fail(particle, fmt::format("asks for a time-step of {:.3g}, too short to change the time", dt),
       "is a velocity or an energy there in other units? A smaller time.courant may help");
}

void fail_below_shortest(const StuckParticle& particle, double dt, double shortest) {
  fail(particle,
       fmt::format("asks for a time-step of {:.3g}, below the shortest one, {:.3g}, which is 1e-13 of the time between "
                   "two snapshots",
                   dt, shortest),
       "more snapshots (output.snapshots) allow shorter steps");
}

}  // namespace sphk
