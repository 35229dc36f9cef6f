#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/cli/commands.hpp"
#include "src/report/machine.hpp"
#include "src/report/quantity.hpp"
#include "src/schemes/registry.hpp"

namespace sphk {

namespace {

/// Size of a snapshot on disk without compression: its fields in double, and the ids.
double snapshot_bytes(const Snapshot& snapshot) {
  double numbers = static_cast<double>(snapshot.size());
  for (const Field& field : snapshot.fields) numbers += static_cast<double>(field.values.size());
  return 8 * numbers;
}

}  // namespace

int dry_run_command(const Problem& problem) {
  constexpr int trial_steps = 3;
  const Settings& settings = problem.settings;
  const SimulationSettings simulation_keys = simulation_settings(settings);
  const ParticleSet particles = problem.scene->build(settings);
  const auto simulation = make_simulation(particles, simulation_keys);
  const double end = settings.real("time.end");
  const Stopwatch watch;
  for (int step = 0; step < trial_steps && simulation->time() < end; ++step) simulation->step(end);
  const double seconds = watch.wall() / trial_steps;

  const double dt = simulation->last_step().dt;
  const double bytes = simulation->costs().bytes_per_particle;
  const double snapshots = 1.0 + static_cast<double>(settings.integer("output.snapshots"));
  double steps = trial_steps + std::max(0.0, std::ceil((end - simulation->time()) / dt));
  if (const auto limit = settings.integer("time.max_steps"); limit > 0)
    steps = std::min(steps, static_cast<double>(limit));
  fmt::print("{}: scheme {}, kernel {}, {:g} neighbours, {} precision\n", problem.scene->name(), simulation_keys.scheme,
             simulation_keys.kernel, simulation_keys.neighbours, simulation_keys.precision);
  fmt::print("  particles   {} in {}D\n", particles.size(), particles.dimension);
  fmt::print("  memory      {} ({:.0f} bytes per particle on the device); peak so far {}\n",
             bytes_text(bytes * static_cast<double>(particles.size())), bytes, bytes_text(peak_memory_bytes()));
  fmt::print("  time-step   {:.3e} after {} steps\n", dt, trial_steps);
  fmt::print("  steps       about {:.0f} to t = {:g}, if the time-step stays as it is\n", steps, end);
  fmt::print("  output      {} in {:.0f} snapshots\n", bytes_text(snapshots * snapshot_bytes(simulation->snapshot())),
             snapshots);
  fmt::print("  run time    about {} ({:.3g} s a step; nothing was written)\n", duration_text(steps * seconds),
             seconds);
  return ExitCode::done;
}

}  // namespace sphk
