// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "kernels/smoothing/list.hpp"

namespace sphk {

namespace detail {
template <class L>
struct ToTestTypes;
template <class... Ts>
struct ToTestTypes<List<Ts...>> {
  using type = testing::Types<Ts...>;
};
}  // namespace detail

using AllKernels = detail::ToTestTypes<SmoothingKernels>::type;

/// Places inside the support where the shape changes its polynomial.
template <class Kernel>
struct Knots {
  static std::vector<double> at() { return {}; }
};
template <>
struct Knots<CubicSpline> {
  static std::vector<double> at() { return {1.0 / 2}; }
};
template <>
struct Knots<CoreTriangle> {
  static std::vector<double> at() { return {1.0 / 3, 1.0 / 2}; }
};
template <>
struct Knots<CoreTriangleForces> : Knots<CubicSpline> {};
template <>
struct Knots<Hydra> {
  static std::vector<double> at() { return {1.0 / 2}; }
};
template <int n>
struct Knots<Hoct<n>> {
  static std::vector<double> at() { return {Hoct<n>::kappa, 1.0 / 2, 3.0 / 4}; }
};
template <>
struct Knots<Liq> {
  static std::vector<double> at() { return {0.3}; }
};
template <>
struct Knots<BSpline<5>> {
  static std::vector<double> at() { return {1.0 / 5, 3.0 / 5}; }
};
template <>
struct Knots<BSpline<6>> {
  static std::vector<double> at() { return {1.0 / 3, 2.0 / 3}; }
};

/// Composite Simpson rule on an even number of intervals.
template <class F>
double simpson(F&& f, double a, double b, int intervals) {
  const double step = (b - a) / intervals;
  double sum = f(a) + f(b);
  for (int k = 1; k < intervals; ++k) sum += (k % 2 ? 4 : 2) * f(a + k * step);
  return sum * step / 3;
}

}  // namespace sphk
