// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "src/engine/particle_set.hpp"

namespace sphk {

/// Gas of which a map is made: n rows everywhere. Particles with a number that is not finite are left out.
struct ProjectedGas {
  std::span<const double> x;       ///< positions, three numbers a particle
  std::span<const double> volume;  ///< mass over density; an area in 2D
  std::span<const double> value;   ///< of the field that is shown
};

/// What the map shows, and on how many pixels. Of a periodic axis all images are seen, of an open one the gas alone.
struct PictureFrame {
  int dimension = 2;             ///< 2 or 3
  Box box;                       ///< whose periodic axes count
  std::array<double, 2> lower;   ///< corner of the picture
  std::array<double, 2> size;    ///< of the picture
  std::array<int, 2> pixels;     ///< along x and along y
  std::optional<double> z = {};  ///< the height of a slice through gas in 3D; nothing: the integral along z
};

/// Rows of pixels from the bottom to the top, each from left to right.
struct FieldMap {
  std::vector<double> values;
  std::vector<double> cover;  ///< the share of a pixel that gas fills, 1 inside it; empty for an integral along z
};

/// A particle's kernel on the map has this radius, in units of its spacing, the D-th root of its volume.
inline constexpr double map_radius = 2.5;
/// A smaller one, in pixels, becomes as large as this: no particle falls between the pixels' centres.
inline constexpr double least_map_radius = 1.5;

/// The field on a grid of pixels. Every particle is drawn with the kernel (1 - q^2)^3, its own kernel and neighbour
/// number play no part, so that pictures of unlike ones compare; along z this is the integral of (1 - q^2)^(5/2). The
/// kernel is evaluated at the centres of the pixels, and these weights are scaled such that all of them, those outside
/// of the picture as well, sum up to the particle's volume: the integral over the map of an integral along z is that of
/// the field over the gas, to rounding, however small the particles are. In a slice and in 2D, `values` is the mean of
/// the particles' values by these weights, NaN where there is no gas. Kokkos must be running; the map does not depend
/// on the number of threads.
FieldMap project(const ProjectedGas& gas, const PictureFrame& frame);

}  // namespace sphk
