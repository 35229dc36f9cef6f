// SPDX-License-Identifier: BSD-3-Clause
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

/// The rows of a field of vectors, one after the other.
inline std::vector<double> flat(const std::vector<Array3>& rows) {
  std::vector<double> values;
  for (const Array3& row : rows) values.insert(values.end(), row.begin(), row.end());
  return values;
}

/// Those fields of the particles at `time`, and their tags.
inline Snapshot snapshot_with(const ParticleSet& gas, double time, double gamma, std::vector<Field> fields) {
  Snapshot snapshot;
  snapshot.dimension = gas.dimension;
  snapshot.box = gas.box;
  snapshot.time = time;
  snapshot.gamma = gamma;
  for (std::size_t i = 0; i < gas.size(); ++i) snapshot.id.push_back(i + 1);
  snapshot.fields = std::move(fields);
  snapshot.fields.push_back(phase_tags(gas));
  return snapshot;
}

/// The scene's particles as a snapshot at `time` with the gas state of `state(x)`.
template <class F>
Snapshot snapshot_of(const ParticleSet& gas, double time, F&& state) {
  std::vector<Array3> v;
  std::vector<double> rho, P, m;
  for (const Array3& x : gas.x) {
    const GasState here = state(x);
    v.push_back(here.v);
    rho.push_back(here.rho);
    P.push_back(here.P);
    m.push_back(here.rho / static_cast<double>(gas.size()));  // of even cells of a unit box
  }
  return snapshot_with(gas, time, 5.0 / 3,
                       {{"Coordinates", "", {}, 3, flat(gas.x)},
                        {"Velocities", "", {}, 3, flat(v)},
                        {"Densities", "", {}, 1, rho},
                        {"Pressures", "", {}, 1, P},
                        {"Masses", "", {}, 1, m}});
}

/// The exact solution at `time` on the scene's particles.
inline Snapshot exact_snapshot(const Scene& scene, const Settings& settings, double time) {
  const auto exact = scene.exact(settings);
  return snapshot_of(scene.build(settings), time, [&](const Array3& x) { return exact(x, time); });
}

/// The scene's particles as the snapshot of its start, with the exact densities `density(x)`.
template <class F>
Snapshot start_snapshot(const ParticleSet& gas, double gamma, F&& density) {
  std::vector<double> rho, A;
  for (std::size_t i = 0; i < gas.size(); ++i) {
    rho.push_back(density(gas.x[i]));
    A.push_back((gamma - 1) * gas.u[i] * std::pow(rho[i], 1 - gamma));
  }
  return snapshot_with(gas, 0, gamma,
                       {{"Coordinates", "", {}, 3, flat(gas.x)},
                        {"Velocities", "", {}, 3, flat(gas.v)},
                        {"Masses", "", {}, 1, gas.m},
                        {"InternalEnergies", "", {}, 1, gas.u},
                        {"Densities", "", {}, 1, rho},
                        {"Entropies", "", {}, 1, A}});
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
