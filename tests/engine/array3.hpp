// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/engine/particle_set.hpp"

namespace sphk::test {

inline double dot(const Array3& a, const Array3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Array3 difference(const Array3& a, const Array3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// to += factor * a
inline void add(Array3& to, double factor, const Array3& a) {
  for (int d = 0; d < 3; ++d) to[d] += factor * a[d];
}

}  // namespace sphk::test
