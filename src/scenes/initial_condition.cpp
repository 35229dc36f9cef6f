// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/initial_condition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "src/engine/errors.hpp"
#include "src/scenes/keys.hpp"
#include "src/schemes/registry.hpp"

namespace sphk {

namespace {

/// A run of the gas with ids 1, 2, ...: its snapshots, which are sorted by id, have the order of the gas' rows.
std::unique_ptr<Simulation> run_by_row(ParticleSet& gas, const SimulationSettings& settings) {
  std::vector<std::uint64_t> id = std::exchange(gas.id, {});
  auto run = make_simulation(gas, settings);
  gas.id = std::move(id);
  return run;
}

/// u = P / ((gamma - 1) rho) with the density that the run's own smoothing kernel measures.
void set_pressure(ParticleSet& gas, double P, const Settings& settings) {
  const SimulationSettings simulation = simulation_settings(settings);
  const auto measured = run_by_row(gas, simulation);
  const Snapshot snapshot = measured->view();
  const std::vector<double>& rho = snapshot.field("Densities").values;
  for (std::size_t i = 0; i < gas.size(); ++i) gas.u[i] = P / ((simulation.gamma - 1) * rho[i]);
}

constexpr double most_steps = 1e6;  ///< that gas settles for

void relax(ParticleSet& gas, double time, const Settings& settings) {
  SimulationSettings simulation = under_scheme(simulation_settings(settings), "relaxation");
  simulation.precision = "mixed";
  simulation.steps = global_steps;
  simulation.numbers.set("time.motion", 1);
  const double start = std::exchange(gas.time, 0);
  std::vector<Array3> v = std::exchange(gas.v, std::vector<Array3>(gas.size()));
  const auto run = run_by_row(gas, simulation);
  gas.time = start;
  gas.v = std::move(v);
  run->step(time);
  if (const double dt = run->time(); time > most_steps * dt)
    throw InputError(
        fmt::format("ic.relax = {:g}: the gas would settle for about {:.1e} time-steps of {:.3g}, more than the {:.0e} "
                    "that any needs; "
                    "it takes some crossings of the box by sound",
                    settings.real("ic.relax"), time / dt, dt, most_steps));
  while (run->time() < time) run->step(time);
  const Snapshot settled = run->view();
  std::ranges::copy(rows(settled.field("Coordinates")), gas.x.begin());
  gas.u = settled.field("InternalEnergies").values;
}

}  // namespace

void smooth_temperatures(ParticleSet& gas, double P, const Settings& settings) {
  if (settings.text("scene.temperatures") == "smoothed") set_pressure(gas, P, settings);
}

void declare_initial_condition_keys(Settings& settings) {
  declare_real(settings, "ic.pressure", 0.0,
               "pressure from which, with the measured density, every u follows; 0: u of the scene",
               {.min = 0, .max = 1e300});
  declare_real(settings, "ic.relax", 0.0,
               "time that the gas settles from rest before the run, without heating by work (V10)",
               {.min = 0, .max = 1e300});
  declare_integer(settings, "ic.rounds", 1,
                  "parts of ic.relax; with more than one, every u follows from ic.pressure again after each",
                  {.min = 1, .max = 10000});
}

ParticleSet initial_condition(const Scene& scene, const Settings& settings) {
  ParticleSet gas = scene.build(settings);
  const double P = settings.real("ic.pressure"), time = settings.real("ic.relax");
  const auto rounds = settings.integer("ic.rounds");
  if (P > 0) set_pressure(gas, P, settings);
  if (time > 0) {
    for (std::int64_t round = 0; round < rounds; ++round) {
      relax(gas, time / static_cast<double>(rounds), settings);
      if (P > 0 && rounds > 1) set_pressure(gas, P, settings);
    }
    scene.set_velocities(gas, settings);
  }
  return gas;
}

}  // namespace sphk
