// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/core/sphere.hpp"

namespace sphk {

/// V_D in a number of dimensions that run time knows. The surface of the sphere is D V_D.
constexpr double unit_sphere_volume(int dimension) {
  return dimension == 1 ? unit_sphere<1> : dimension == 2 ? unit_sphere<2> : unit_sphere<3>;
}

}  // namespace sphk
