#include "src/engine/output.hpp"

#include <fmt/format.h>

namespace sphk {

void require_finite(const StepLimit& limit, double time, long step) {
  if (limit.dt > 0) return;
  throw NumericsError(
      fmt::format("step {}, t = {}: the time-step C h / v_sig of particle {} is not a positive number: a velocity, an "
                  "energy or a density is not finite. Look at the last snapshot around that particle; a smaller "
                  "time.courant may help.",
                  step, time, limit.particle));
}

void require_progress(const StepLimit& limit, double dt, double time, long step) {
  if (time + dt > time) return;
  throw NumericsError(fmt::format(
      "step {}, t = {}: particle {} asks for a time-step of {:.3g}, too short to change the time. Look at the "
      "last snapshot around that particle; a smaller time.courant may help.",
      step, time, limit.particle, dt));
}

void require_tick(const StepLimit& limit, const StepClock& clock, double time, long step) {
  if (!clock.individual || limit.dt >= clock.tick) return;
  throw NumericsError(fmt::format(
      "step {}, t = {}: particle {} asks for a time-step of {:.3g}, below the shortest one, {:.3g}, which is "
      "1e-13 of the time between two snapshots. Look at the last snapshot around that particle; more "
      "snapshots (output.snapshots) allow shorter steps.",
      step, time, limit.particle, limit.dt, clock.tick));
}

std::vector<std::string> warnings_of(const SupportCounts& searches, const FitCounts& fits) {
  std::vector<std::string> warnings;
  if (searches.capped > 0)
    warnings.push_back(
        fmt::format("{} searches ended at the largest support radius with fewer neighbours than asked: raise "
                    "sph.h_max or lower sph.neighbours",
                    searches.capped));
  if (searches.crowded > 0)
    warnings.push_back(
        fmt::format("{} searches found more coincident particles than neighbours asked: their support holds "
                    "nobody else; `sphk ic check` lists them",
                    searches.crowded));
  if (searches.failed > 0)
    warnings.push_back(fmt::format("{} searches for a support radius did not converge", searches.failed));
  if (fits.linear + fits.sph > 0)
    warnings.push_back(fmt::format(
        "{} fits of the velocity gradients were linear and {} gave way to the SPH estimate: too few neighbours, or on "
        "a line or plane; more of them (sph.neighbours) allow second order",
        fits.linear, fits.sph));
  return warnings;
}

}  // namespace sphk
