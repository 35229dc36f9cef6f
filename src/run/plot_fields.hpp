#pragma once

#include <filesystem>
#include <string>
#include <vector>

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

/// Throws InputError with the names that there are where `name` is none of them.
PlotField find_plot_field(const std::vector<PlotField>& fields, const std::string& name,
                          const std::filesystem::path& snapshot);

/// The least value, of a field that does not depend on where the scene's centre is. Throws InputError.
double least_value(const PlotField& field, const std::filesystem::path& snapshot);

}  // namespace sphk
