// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/kernel_gamma.hpp"

#include <cmath>

#include "kernels/smoothing/list.hpp"

namespace sphk {

namespace {

/// Integral of w q^power over [0, 1] by Simpson's rule; the knots of most kernels are nodes, the rest costs 1e-8.
template <class Kernel>
double moment(const Kernel& kernel, int power) {
  constexpr int intervals = 3 * 4096;
  double sum = 0;
  for (int i = 0; i <= intervals; ++i) {
    const double q = static_cast<double>(i) / intervals;
    const int weight = i == 0 || i == intervals ? 1 : i % 2 ? 4 : 2;
    sum += weight * kernel.w(q) * std::pow(q, power);
  }
  return sum / (3.0 * intervals);
}

}  // namespace

double kernel_gamma(const std::string& kernel, int dimension) {
  return with_kernel(kernel, [&](const auto& shape) {
    const double sigma2 = moment(shape, dimension + 1) / (dimension * moment(shape, dimension - 1));
    return 1 / (2 * std::sqrt(sigma2));  // with the support radius as the unit of length
  });
}

}  // namespace sphk
