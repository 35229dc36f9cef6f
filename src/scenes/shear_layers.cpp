// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/shear_layers.hpp"

#include <cmath>

#include "src/scenes/initial_condition.hpp"
#include "src/scenes/keys.hpp"
#include "src/scenes/mass_profile.hpp"

namespace sphk {

namespace {

/// n x n particles of the light gas's spacing, times scene.layers in 3D.
Block even_block(const Settings& settings, double lower) {
  const int n = scene_n(settings);
  Block block{.dimension = scene_dimension(settings), .counts = {n, n, 1}, .lower = {lower, lower, 0}};
  if (block.dimension == 2) return block;
  block.counts[2] = static_cast<int>(settings.integer("scene.layers"));
  block.size[2] = double(block.counts[2]) / n;
  block.lower[2] = -block.size[2] / 2;
  return block;
}

std::string arrangement(const Settings& settings) {
  return settings.has("scene.lattice") ? settings.text("scene.lattice") : "cubic";
}

void place_even(ParticleSet& gas, const Block& even, const LayeredFlow& flow, const Settings& settings) {
  gas.x = arranged_points(even, arrangement(settings));
  for (const Array3& x : gas.x) gas.m.push_back(flow.rho(x[1]) * even.size[2] / double(gas.size()));
}

}  // namespace

void ShearLayers::declare(Settings& settings) const {
  const Defaults standard = defaults();
  declare_resolution(settings, standard.n, "particles of the light gas along the unit box");
  declare_dimension(settings, standard.dimension, 2);
  declare_integer(settings, "scene.layers", 8,
                  "layers of the light gas across the slab, 3D only (R10 has 8 at n = 256)", {.min = 1, .max = 100000});
  declare_masses(settings, "equal");
  declare_temperatures(settings);
  declare_real(settings, "scene.boost", 0.0, "speed along x that is added to all gas");
  prefer_unless_set(settings, "output.snapshots", std::int64_t{standard.snapshots});
  prefer_unless_set(settings, "sph.scheme", "sphs");
  prefer_usual_gas(settings, standard.end);
}

ParticleSet ShearLayers::build(const Settings& settings) const {
  const LayeredFlow flow = this->flow(settings);
  const Block even = even_block(settings, flow.lower);
  ParticleSet gas;
  gas.dimension = even.dimension;
  gas.box = {even.lower, even.size, {true, true, even.dimension == 3}};
  if (has_equal_masses(settings))
    place_equal_masses(gas, flow, settings);
  else
    place_even(gas, even, flow, settings);
  set_velocities(gas, settings);
  for (const auto& [x, y, z] : gas.x) {
    gas.u.push_back(GasState{.rho = flow.rho(y), .P = flow.pressure}.u(settings.real("sph.gamma")));
    gas.tag.push_back(y >= flow.interfaces[0] && y < flow.interfaces[1] ? dense_gas : light_gas);
  }
  smooth_temperatures(gas, flow.pressure, settings);
  return gas;
}

void ShearLayers::set_velocities(ParticleSet& gas, const Settings& settings) const {
  const LayeredFlow flow = this->flow(settings);
  const double boost = settings.real("scene.boost");
  gas.v.clear();
  for (const auto& [x, y, z] : gas.x) gas.v.push_back({flow.v_x(y) + boost, flow.v_y(x, y), 0});
}

Measures ShearLayers::measures(const Settings& settings, const Snapshot& snapshot) const {
  const LayeredFlow flow = this->flow(settings);
  const double gamma = settings.real("sph.gamma");
  return layer_measures(snapshot, {.interfaces = flow.interfaces,
                                   .wavelength = flow.wavelength,
                                   .A_light = flow.pressure / std::pow(flow.rho_light, gamma),
                                   .A_dense = flow.pressure / std::pow(flow.rho_dense, gamma)});
}

PlotHint ShearLayers::plot_hint(const Settings& settings) const {
  const double lower = flow(settings).lower;
  return {.abscissa = "y", .from = lower, .to = lower + 1, .map = true};
}

void ShearLayers::place_equal_masses(ParticleSet& gas, const LayeredFlow& flow, const Settings& settings) const {
  const MassProfile profile(flow.rho, flow.lower, 1);
  for (const Block& block : equal_mass_blocks(even_block(settings, flow.lower)))
    for (Array3 x : arranged_points(block, arrangement(settings))) {
      x[1] = profile.place(x[1]);
      gas.x.push_back(x);
    }
  gas.m.assign(gas.size(), profile.mass() * gas.box.size[2] / double(gas.size()));
}

std::vector<Block> ShearLayers::equal_mass_blocks(const Block& even) const {
  Block rows = even;
  rows.lower[1] = 0;
  return {rows};
}

}  // namespace sphk
