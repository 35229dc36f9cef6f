// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "src/scenes/scene.hpp"

namespace sphk {

/// The coordinate along which a scene is one-dimensional, and where its norms are taken.
struct ProfileLine {
  /// x, cylindrical R or spherical r of a place.
  std::function<double(const Array3& x)> coordinate;
  /// Unit vector of the velocity component that is compared.
  std::function<Array3(const Array3& x)> direction;
  double from = 0, to = 1;  ///< range of the coordinate
  double width = 0.01;      ///< of a bin
};

double dot(const Array3& a, const Array3& b);
/// Distance from the origin.
double radius(const Array3& x);

/// Along x; the place of a coordinate s is (s, 0, 0) for all of them.
ProfileLine along_x(double from, double to);
/// Distance from the origin with the radial velocity.
ProfileLine along_r(double to);
/// Distance from the z axis with the azimuthal velocity.
ProfileLine along_R(double to);

/// Errors of v, rho and P by field name. The plain names compare the mean over the particles of every bin with the
/// mean of the exact solution at their places (S12 eq 44), so that particles that carry the exact solution score 0;
/// bins without a particle are left out. "v_centres" and so on compare it with the exact value at the bin's centre,
/// as errors of other engines were measured, "v_particles" every particle with the exact value at its place. Empty
/// when no particle lies in the range.
Errors profile_errors(const Snapshot& snapshot, const ProfileLine& line, const ExactSolution& exact);

/// What the error of that name is the mean of, in words; empty: profile_errors() has none of that name.
std::string meaning_of_error(const std::string& name);

}  // namespace sphk
