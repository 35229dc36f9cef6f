#pragma once

#include <cmath>
#include <string>

#include "src/scenes/scenes.hpp"

namespace sphk {

/// The engine keys that scenes prefer values of, then the scene's own, as a run declares them.
inline Settings settings_of(const Scene& scene) {
  Settings settings;
  for (const char* name : {"sph.gamma", "sph.neighbours", "time.end", "gravity.central_mass", "gravity.softening"})
    settings.declare({.name = name, .value = 0.0, .doc = "", .choices = {}});
  scene.declare(settings);
  return settings;
}

/// The same with keys as the command line sets them, and adapted.
inline Settings settings_of(const Scene& scene, const std::vector<std::pair<std::string, std::string>>& keys) {
  Settings settings = settings_of(scene);
  for (const auto& [name, text] : keys) settings.set_from_text(name, text, Origin::command_line);
  scene.adapt(settings);
  return settings;
}

/// The scene's particles as a snapshot at `time` with the gas state of `state(x)`.
template <class F>
Snapshot snapshot_of(const ParticleSet& gas, double time, F&& state) {
  Snapshot snapshot{.dimension = gas.dimension, .box = gas.box, .time = time};
  Field x{.name = "Coordinates", .components = 3}, v{.name = "Velocities", .components = 3};
  Field rho{.name = "Densities"}, P{.name = "Pressures"}, m{.name = "Masses"};
  for (std::size_t i = 0; i < gas.size(); ++i) {
    const GasState here = state(gas.x[i]);
    snapshot.id.push_back(i + 1);
    x.values.insert(x.values.end(), gas.x[i].begin(), gas.x[i].end());
    v.values.insert(v.values.end(), here.v.begin(), here.v.end());
    rho.values.push_back(here.rho);
    P.values.push_back(here.P);
    m.values.push_back(here.rho / static_cast<double>(gas.size()));  // of even cells of a unit box
  }
  snapshot.fields = {x, v, rho, P, m, phase_tags(gas)};
  return snapshot;
}

/// The exact solution at `time` on the scene's particles.
inline Snapshot exact_snapshot(const Scene& scene, const Settings& settings, double time) {
  const auto exact = scene.exact(settings);
  return snapshot_of(scene.build(settings), time, [&](const Array3& x) { return exact(x, time); });
}

/// The scene's particles as the snapshot of its start, with the exact densities `rho(x)`.
template <class F>
Snapshot start_snapshot(const ParticleSet& gas, double gamma, F&& rho) {
  Snapshot snapshot{.dimension = gas.dimension, .box = gas.box, .gamma = gamma};
  Field x{.name = "Coordinates", .components = 3}, v{.name = "Velocities", .components = 3};
  Field m{.name = "Masses", .values = gas.m}, u{.name = "InternalEnergies", .values = gas.u};
  Field density{.name = "Densities"}, A{.name = "Entropies"};
  for (std::size_t i = 0; i < gas.size(); ++i) {
    snapshot.id.push_back(i + 1);
    x.values.insert(x.values.end(), gas.x[i].begin(), gas.x[i].end());
    v.values.insert(v.values.end(), gas.v[i].begin(), gas.v[i].end());
    density.values.push_back(rho(gas.x[i]));
    A.values.push_back((gamma - 1) * gas.u[i] * std::pow(density.values[i], 1 - gamma));
  }
  snapshot.fields = {x, v, m, u, density, A, phase_tags(gas)};
  return snapshot;
}

inline double total_mass(const ParticleSet& gas) {
  double mass = 0;
  for (const double m : gas.m) mass += m;
  return mass;
}

/// Every particle lies in its box.
inline bool inside_box(const ParticleSet& gas) {
  for (const Array3& x : gas.x)
    for (int axis = 0; axis < gas.dimension; ++axis) {
      const double s = x[axis] - gas.box.lower[axis];
      if (!(s >= 0 && s < gas.box.size[axis])) return false;
    }
  return true;
}

}  // namespace sphk
