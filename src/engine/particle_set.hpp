// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace sphk {

using Array3 = std::array<double, 3>;

/// The simulated volume: [lower, lower + size) along every axis; an axis is periodic or open.
/// Axes beyond the true dimension have size 1 and are open.
struct Box {
  Array3 lower{0, 0, 0};
  Array3 size{1, 1, 1};
  std::array<bool, 3> periodic{false, false, false};
};

/// Gas of an initial condition on the host, in code units; n rows everywhere; vectors padded with zeros in 1D and 2D.
struct ParticleSet {
  int dimension = 3;
  Box box;
  double time = 0;
  std::vector<Array3> x;          ///< position
  std::vector<Array3> v;          ///< velocity
  std::vector<double> m;          ///< mass
  std::vector<double> u;          ///< specific thermal energy
  std::vector<double> h;          ///< support radius; may be empty: the engine finds its own
  std::vector<double> alpha;      ///< of the dissipation switch; may be empty: zero
  std::vector<std::uint64_t> id;  ///< unique; may be empty: 1..n
  std::vector<int> tag;           ///< where the gas comes from, a scene's own numbers; may be empty: no such thing

  std::size_t size() const { return x.size(); }
};

/// Powers of length, mass and time in a field's unit: density is {-3, 1, 0} in 3D.
struct UnitExponents {
  double length = 0, mass = 0, time = 0;
};

/// One output field: `values` holds n rows of `components` numbers.
struct Field {
  std::string name;  ///< the snapshot's dataset name, such as "Densities"
  std::string description;
  UnitExponents units;
  int components = 1;
  std::vector<double> values;
  std::function<std::vector<double>()> make = {};  ///< of a field that makes its values when they are asked for

  /// Makes the values of such a field, where they are not there.
  void fill() {
    if (make && values.empty()) values = make();
  }
  /// Lets go of what it can make again.
  void let_go() {
    if (make) values = std::vector<double>();
  }
};

/// The tags of an initial condition, sorted by id; empty where it has none.
std::vector<int> tags_by_id(const ParticleSet& particles);
/// The same as the output field "PhaseTags".
Field phase_tags(const ParticleSet& particles);

/// The state of a run at one time, on the host, sorted by particle id.
/// Always there: Coordinates (3), Velocities (3), Masses, Densities, InternalEnergies, Pressures, SmoothingLength (the
/// support radius) and Entropies (A = P / rho^gamma); a scheme adds its own. PhaseTags where the particles had tags.
struct Snapshot {
  int dimension = 3;
  Box box;
  double time = 0;
  long step = 0;
  double gamma = 5.0 / 3;
  std::vector<std::uint64_t> id;
  mutable std::vector<Field> fields;  ///< of a snapshot that is a view (Simulation::view), without values at first

  std::size_t size() const { return id.size(); }
  /// The field of that name, with its values; throws std::out_of_range naming it when the scheme has none such.
  const Field& field(const std::string& name) const;
  bool has(const std::string& name) const;
  /// Lets go of values that can be made again.
  void let_go() const;
};

}  // namespace sphk
