#pragma once

#include <numbers>

namespace sphk {

/// V_D, the volume of the unit sphere in D = 1, 2 or 3 dimensions: 2, pi, 4 pi / 3. Its surface is D V_D.
constexpr double unit_sphere_volume(int dimension) {
  return dimension == 1 ? 2 : dimension == 2 ? std::numbers::pi : 4.18879020478639098462;
}

}  // namespace sphk
