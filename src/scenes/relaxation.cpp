#include "src/scenes/relaxation.hpp"

#include "src/schemes/registry.hpp"

namespace sphk {

void declare_relaxation(Settings& settings) {
  settings.declare(
      {.name = "scene.relax",
       .value = 0.0,
       .doc = "time that the gas settles from rest before the run, without heating by work (V10 sec 4.5.1)",
       .choices = {},
       .min = 0,
       .max = 1e300});
}

bool relax(ParticleSet& gas, const Settings& settings) {
  const double time = settings.real("scene.relax");
  if (time == 0) return false;
  SimulationSettings simulation = simulation_settings(settings);
  simulation.scheme = "relaxation";
  simulation.energy = "energy";
  simulation.precision = "mixed";
  simulation.individual_steps = false;
  ParticleSet resting = gas;
  resting.time = 0;
  resting.id.clear();  // 1, 2, ...: the order of the rows
  resting.v.assign(gas.size(), {0, 0, 0});
  const auto run = make_simulation(resting, simulation);
  while (run->time() < time) run->step(time);
  const Snapshot settled = run->snapshot();
  const std::vector<double>&x = settled.field("Coordinates").values, &u = settled.field("InternalEnergies").values;
  for (std::size_t i = 0; i < gas.size(); ++i) gas.x[i] = {x[3 * i], x[3 * i + 1], x[3 * i + 2]}, gas.u[i] = u[i];
  return true;
}

}  // namespace sphk
