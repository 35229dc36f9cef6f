#include "src/scenes/temperatures.hpp"

#include "src/scenes/keys.hpp"
#include "src/schemes/registry.hpp"

namespace sphk {

void declare_temperatures(Settings& settings) {
  declare_choice(settings, "scene.temperatures", "exact",
                 "exact: u of the true density; smoothed: of the measured one, which evens out P at the edges",
                 {"exact", "smoothed"});
}

void set_pressure(ParticleSet& gas, double P, const Settings& settings) {
  const SimulationSettings simulation = simulation_settings(settings);
  const std::vector<double> rho = make_simulation(gas, simulation)->snapshot().field("Densities").values;
  for (std::size_t i = 0; i < gas.size(); ++i) gas.u[i] = P / ((simulation.gamma - 1) * rho[i]);
}

void smooth_temperatures(ParticleSet& gas, double P, const Settings& settings) {
  if (settings.text("scene.temperatures") == "smoothed") set_pressure(gas, P, settings);
}

}  // namespace sphk
