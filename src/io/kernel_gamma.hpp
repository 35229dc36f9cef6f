// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace sphk {

/// SWIFT's "kernel gamma": the support radius over SWIFT's h, which is twice the kernel's standard deviation sigma with
/// sigma^2 = (1/D) int x^2 W d^Dx (Dehnen & Aly 2012, eq 8): 1.825742 for the cubic spline in 3D. `kernel` is any name
/// of kernel_names(); throws std::invalid_argument for another.
double kernel_gamma(const std::string& kernel, int dimension);

}  // namespace sphk
