// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "kernels/core/vec.hpp"

// Header-only use: |(3, 4)| = 5.
int main() {
  const sphk::Vec<double, 2> x{3.0, 4.0};
  return std::sqrt(dot(x, x)) == 5.0 ? 0 : 1;
}
