// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "src/engine/particle_set.hpp"

namespace sphk {

/// Tags of the particles: the gas they belonged to at the start.
inline constexpr int light_gas = 0, dense_gas = 1;

/// Layers normal to y in a box that is periodic along y: dense gas between the two interfaces at the start.
struct LayerGeometry {
  std::array<double, 2> interfaces{};
  double wavelength = 0.5;  ///< of the mode along x whose growth is measured
  double A_light = 1, A_dense = 1;
};

/// M: amplitude of v_y in the mode of that wavelength, near an interface y_i: 2 sqrt(S^2 + C^2) / N with
/// S = sum v_y sin(kx) w V, C the same with the cosine, N = sum w V, w = exp(-k |y - y_i|), k = 2 pi / wavelength,
/// V = m / rho, over the half of the box around y_i (McNally, Lyra & Passy 2012). The mean over the two
/// interfaces. A moving frame does not change it.
double mode_amplitude(const Snapshot& snapshot, const LayerGeometry& layers);

/// W: width of a mixed zone, integral of 4 Y (1 - Y) dy, Y(y) the mass fraction of gas of dense origin, over 256 rows
/// of the box; 0 as long as no row holds both gases. A particle lies evenly over the length (m / rho)^(1/D) along y, so
/// that W hangs neither on the number of particles nor on which rows hold their centres. Half of the integral over the
/// box: the mean over the two interfaces.
double mixed_width(const Snapshot& snapshot);

/// mixA: mass fraction with 0.1 < ln(A / A_dense) / ln(A_light / A_dense) < 0.9.
double mixed_entropy_fraction(const Snapshot& snapshot, const LayerGeometry& layers);

/// crossed: fraction of the mass of dense origin that lies outside of its first layer.
double crossed_fraction(const Snapshot& snapshot, const LayerGeometry& layers);

/// The four above under their names in history.csv: M, W, mixA, crossed.
std::vector<std::pair<std::string, double>> layer_measures(const Snapshot& snapshot, const LayerGeometry& layers);

/// What still counts as a cloud.
struct CloudGas {
  double least_density = 0, highest_energy = 0;
};

/// cloud_mass: mass of the gas above that density and below that specific energy, over all mass of dense origin. At the
/// start it is less than 1 by the cloud's skin, whose density the smoothing kernel lowers.
double cloud_mass(const Snapshot& snapshot, const CloudGas& cloud);

/// cold_share: mass of the gas of dense origin below that specific energy, over all of it: 1 as long as none mixes.
double cold_share(const Snapshot& snapshot, double highest_energy);

/// cloud_velocity: mean v_x of all gas of dense origin, by mass.
double cloud_velocity(const Snapshot& snapshot);

}  // namespace sphk
