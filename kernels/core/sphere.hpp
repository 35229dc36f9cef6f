// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace sphk {

/// V_D, the volume of the unit sphere in D = 1, 2 or 3 dimensions.
template <int D>
inline constexpr double unit_sphere = D == 1   ? 2
                                      : D == 2 ? 3.14159265358979323846
                                               : 4.18879020478639098462;

}  // namespace sphk
