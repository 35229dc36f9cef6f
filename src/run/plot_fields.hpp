// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "src/engine/particle_set.hpp"

namespace sphk {

/// What figures can show of a snapshot: a dataset of its particles, or a part of one.
struct PlotField {
  std::string name;     ///< as users say it: rho, v_y, E0_R, |E0|, alpha, VelocityDivergence, R_xy
  std::string dataset;  ///< of PartType0
  /// x, y, z of a vector, xx, yy, zz, xy, xz, yz of a matrix; R, phi (cylindrical) and r (spherical) about the scene's
  /// centre; modulus; empty: the dataset is a number a particle.
  std::string part;
};

/// The dataset of the dissipation parameter.
inline constexpr const char* alpha_dataset = "Alpha";

/// All that the snapshot has, those with short names first. A vector's own name is its modulus, as |v| is.
std::vector<PlotField> plot_fields(const std::filesystem::path& snapshot, int dimension);

/// Throws InputError: `name` is no field of the snapshot, and which ones there are.
[[noreturn]] void refuse_plot_field(const std::vector<PlotField>& fields, const std::string& name,
                                    const std::filesystem::path& snapshot);

/// A scene's centre: where it is, and how it moves.
struct PlotCentre {
  Array3 place{}, velocity{};
};

/// The vector from the centre to x, by the nearest image along periodic axes.
Array3 offset(const Array3& x, const Array3& centre, const ParticleSet& gas);

/// A number a particle, in the file's order. Velocities along R, phi and r are beside the centre's own; those of a
/// particle in the centre are 0. Throws InputError.
std::vector<double> field_values(const PlotField& field, const std::filesystem::path& snapshot, const ParticleSet& gas,
                                 const PlotCentre& centre);

}  // namespace sphk
