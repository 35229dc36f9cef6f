// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/mixing.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "src/scenes/block.hpp"

namespace sphk {

namespace {

using Condition = std::function<bool(std::size_t)>;

/// Mass of the particles for which `counts` holds.
double mass_where(const Snapshot& snapshot, const Condition& counts) {
  const auto& m = snapshot.field("Masses").values;
  double sum = 0;
  for (std::size_t i = 0; i < snapshot.size(); ++i)
    if (counts(i)) sum += m[i];
  return sum;
}

Condition of_dense_origin(const Snapshot& snapshot) {
  const auto& tags = snapshot.field("PhaseTags").values;
  return [&tags](std::size_t i) { return tags[i] == dense_gas; };
}

double mode_amplitude_at(const Snapshot& snapshot, double interface, double k) {
  const auto &x = snapshot.field("Coordinates").values, &v = snapshot.field("Velocities").values;
  const auto &m = snapshot.field("Masses").values, &rho = snapshot.field("Densities").values;
  double S = 0, C = 0, N = 0;
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    const double distance = std::remainder(x[3 * i + 1] - interface, snapshot.box.size[1]);
    if (std::abs(distance) > snapshot.box.size[1] / 4) continue;
    const double wV = std::exp(-k * std::abs(distance)) * m[i] / rho[i], v_y = v[3 * i + 1];
    S += v_y * std::sin(k * x[3 * i]) * wV;
    C += v_y * std::cos(k * x[3 * i]) * wV;
    N += wV;
  }
  return 2 * std::hypot(S, C) / N;
}

constexpr int row_count = 256;

/// Mass of all gas and of the gas of dense origin.
struct Row {
  double mass = 0, dense = 0;
};

/// Of the box along y, which is periodic.
std::vector<Row> rows_along_y(const Snapshot& snapshot) {
  const auto &x = snapshot.field("Coordinates").values, &m = snapshot.field("Masses").values;
  const auto& rho = snapshot.field("Densities").values;
  const Condition is_dense = of_dense_origin(snapshot);
  const double height = snapshot.box.size[1] / row_count;
  std::vector<Row> rows(row_count);
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    const double middle = (x[3 * i + 1] - snapshot.box.lower[1]) / height;
    const double length = std::min<double>(std::pow(m[i] / rho[i], 1.0 / snapshot.dimension) / height, row_count);
    const double from = middle - length / 2, to = middle + length / 2;
    for (double row = std::floor(from); row < to; ++row) {
      const double mass = m[i] * (std::min(row + 1, to) - std::max(row, from)) / length;
      Row& here = rows[static_cast<std::size_t>(wrapped(row, row_count))];
      here.mass += mass;
      if (is_dense(i)) here.dense += mass;
    }
  }
  return rows;
}

}  // namespace

double mode_amplitude(const Snapshot& snapshot, const LayerGeometry& layers) {
  const double k = 2 * std::numbers::pi / layers.wavelength;
  return (mode_amplitude_at(snapshot, layers.interfaces[0], k) + mode_amplitude_at(snapshot, layers.interfaces[1], k)) /
         2;
}

double mixed_width(const Snapshot& snapshot) {
  double integral = 0;
  for (const Row& row : rows_along_y(snapshot)) {
    if (row.mass == 0) continue;
    const double Y = row.dense / row.mass;
    integral += 4 * Y * (1 - Y) * snapshot.box.size[1] / row_count;
  }
  return integral / 2;
}

double mixed_entropy_fraction(const Snapshot& snapshot, const LayerGeometry& layers) {
  const auto& A = snapshot.field("Entropies").values;
  const double contrast = std::log(layers.A_light / layers.A_dense);
  const double mixed = mass_where(snapshot, [&](std::size_t i) {
    const double share = std::log(A[i] / layers.A_dense) / contrast;
    return share > 0.1 && share < 0.9;
  });
  return mixed / mass_where(snapshot, [](std::size_t) { return true; });
}

double crossed_fraction(const Snapshot& snapshot, const LayerGeometry& layers) {
  const auto& x = snapshot.field("Coordinates").values;
  const Condition is_dense = of_dense_origin(snapshot);
  const double crossed = mass_where(snapshot, [&](std::size_t i) {
    const double y = x[3 * i + 1];
    return is_dense(i) && !(y >= layers.interfaces[0] && y < layers.interfaces[1]);
  });
  return crossed / mass_where(snapshot, is_dense);
}

std::vector<std::pair<std::string, double>> layer_measures(const Snapshot& snapshot, const LayerGeometry& layers) {
  const double M = mode_amplitude(snapshot, layers);
  snapshot.let_go();  // of velocities
  return {{"M", M},
          {"W", mixed_width(snapshot)},
          {"mixA", mixed_entropy_fraction(snapshot, layers)},
          {"crossed", crossed_fraction(snapshot, layers)}};
}

double cloud_mass(const Snapshot& snapshot, const CloudGas& cloud) {
  const auto &rho = snapshot.field("Densities").values, &u = snapshot.field("InternalEnergies").values;
  const double mass =
      mass_where(snapshot, [&](std::size_t i) { return rho[i] > cloud.least_density && u[i] < cloud.highest_energy; });
  return mass / mass_where(snapshot, of_dense_origin(snapshot));
}

double cold_share(const Snapshot& snapshot, double highest_energy) {
  const auto& u = snapshot.field("InternalEnergies").values;
  const Condition is_dense = of_dense_origin(snapshot);
  const double cold = mass_where(snapshot, [&](std::size_t i) { return is_dense(i) && u[i] < highest_energy; });
  return cold / mass_where(snapshot, is_dense);
}

double cloud_velocity(const Snapshot& snapshot) {
  const auto &m = snapshot.field("Masses").values, &v = snapshot.field("Velocities").values;
  const Condition is_dense = of_dense_origin(snapshot);
  double momentum = 0;
  for (std::size_t i = 0; i < snapshot.size(); ++i)
    if (is_dense(i)) momentum += m[i] * v[3 * i];
  return momentum / mass_where(snapshot, is_dense);
}

}  // namespace sphk
