// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/dry_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <thread>

#include "src/io/snapshot_groups.hpp"
#include "src/report/machine.hpp"
#include "src/report/quantity.hpp"
#include "src/run/run_output.hpp"
#include "src/run/trial_gas.hpp"
#include "src/schemes/registry.hpp"

namespace sphk {

namespace {

/// Measures the gas and makes a snapshot of it, as a run does, without the disk; the size of its file.
double rehearse_output(const Problem& problem, const Simulation& simulation) {
  Snapshot snapshot = simulation.view();
  problem.scene->measures(problem.settings, snapshot);
  snapshot.let_go();
  problem.scene->errors(problem.settings, snapshot);
  snapshot.let_go();
  hdf5::File file = hdf5::File::rehearsed();
  write_snapshot(file, std::move(snapshot), snapshot_info(*problem.scene, problem.settings), Compression::none);
  return file.bytes();
}

/// What some particles of the gas make a run hold: all that does not grow with their number.
double memory_of_few(const Problem& problem, const ParticleSet& gas) {
  const double before = memory_bytes();
  const auto few =
      make_simulation(thinned(gas, std::max<std::size_t>(gas.size() / 1000, 1)), simulation_settings(problem.settings));
  rehearse_output(problem, *few);
  return memory_bytes() - before;
}

}  // namespace

DryRun dry_run(const Problem& problem) {
  const Settings& settings = problem.settings;
  const SimulationSettings s = simulation_settings(settings);
  const double at_first = memory_bytes();
  TrialGas trial = trial_gas(*problem.scene, settings);
  const double constant = at_first + memory_of_few(problem, trial.gas);
  const auto simulation = make_simulation(trial.gas, s);
  DryRun run{.scene = problem.scene->name(),
             .scheme = s.scheme,
             .kernel = s.kernel,
             .precision = s.precision,
             .neighbours = s.neighbours,
             .particles = trial.particles,
             .dimension = trial.gas.dimension,
             .trial_steps = 3,
             .trial_particles = trial.gas.size(),
             .end = settings.real("time.end"),
             .snapshots = 1.0 + static_cast<double>(settings.integer("output.snapshots"))};
  trial.gas = {};
  const Stopwatch watch;
  for (int step = 0; step < run.trial_steps && simulation->time() < run.end; ++step) simulation->step(run.end);
  const double as_many = run.particles / static_cast<double>(run.trial_particles);
  run.seconds_per_step = as_many * watch.wall() / run.trial_steps;
  run.dt = simulation->last_step().dt / trial.refinement;
  run.steps = run.trial_steps + std::max(0.0, std::ceil((run.end - simulation->time()) / run.dt));
  if (const auto limit = settings.integer("time.max_steps"); limit >= 0)
    run.steps = std::min(run.steps, static_cast<double>(limit));
  run.bytes_per_particle = simulation->costs().bytes_per_particle;
  run.output_bytes = as_many * run.snapshots * rehearse_output(problem, *simulation);
  run.peak_bytes = constant + as_many * (peak_memory_bytes() - constant);
  run.available_bytes = available_memory_bytes();
  return run;
}

std::string DryRun::text() const {
  std::string text;
  const auto add = [&](const char* name, const std::string& words) {
    text += fmt::format("  {:<12}{}\n", name, words);
  };
  text = fmt::format("{}: scheme {}, kernel {}, {:g} neighbours, {} precision\n", scene, scheme, kernel, neighbours,
                     precision);
  const bool all = static_cast<double>(trial_particles) == particles;
  add("particles", fmt::format("{:.0f} in {}D{}", particles, dimension,
                               all ? "" : fmt::format(", told from {} of their kind", trial_particles)));
  add("memory", fmt::format("{} at its peak; {:.0f} bytes per particle on the device{}", bytes_text(peak_bytes),
                            bytes_per_particle,
                            peak_bytes < available_bytes
                                ? ""
                                : fmt::format("; MORE than the {} that are free here", bytes_text(available_bytes))));
  add("time-step", fmt::format("{:.3e} after {} steps", dt, trial_steps));
  add("steps", fmt::format("about {:.0f} to t = {:g}, if the time-step stays as it is", steps, end));
  add("output", fmt::format("{} in {:.0f} snapshots", bytes_text(output_bytes), snapshots));
  add("run time",
      fmt::format("about {} ({:.3g} s a step; nothing was written)", duration_text(seconds()), seconds_per_step));
  return text;
}

std::string DryRun::json() const {
  const nlohmann::ordered_json numbers = {{"scene", scene},
                                          {"scheme", scheme},
                                          {"kernel", kernel},
                                          {"precision", precision},
                                          {"neighbours", neighbours},
                                          {"particles", static_cast<std::int64_t>(particles)},
                                          {"trial_particles", trial_particles},
                                          {"dimension", dimension},
                                          {"bytes_per_particle", bytes_per_particle},
                                          {"peak_memory_bytes", peak_bytes},
                                          {"dt", dt},
                                          {"end", end},
                                          {"steps", steps},
                                          {"snapshots", snapshots},
                                          {"output_bytes", output_bytes},
                                          {"seconds_per_step", seconds_per_step},
                                          {"seconds", seconds()}};
  return nlohmann::ordered_json{{"dry_run", numbers}}.dump();
}

/// 10 ns per neighbour and 1.5 us per update beside them, as on a core with AVX2.
double rough_seconds(const ParticleSet& particles, const Settings& settings) {
  const SimulationSettings s = simulation_settings(settings);
  const double n = static_cast<double>(particles.size());
  double volume = 1, mean = 0, largest = 0;
  for (int axis = 0; axis < particles.dimension; ++axis) volume *= particles.box.size[static_cast<std::size_t>(axis)];
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Array3& v = particles.v[i];
    const double sound2 = s.gamma * (s.gamma - 1) * particles.u[i];
    const double signal = std::sqrt(sound2 + v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    mean += signal / n;
    largest = std::max(largest, signal);
  }
  // One step for all follows the fastest particle, which slows down while its energy spreads: hence between the two.
  const double signal = std::sqrt(mean * largest);
  const double spacing = std::pow(volume / n, 1.0 / particles.dimension);
  const double dt = s.courant * spacing / std::max(2 * signal, 1e-300);
  const double steps = std::max(1.0, settings.real("time.end") / dt);
  return n * steps * (1.5e-6 + 1e-8 * s.neighbours) / std::max(1u, std::thread::hardware_concurrency());
}

}  // namespace sphk
