// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "kernels/core/type_list.hpp"
#include "kernels/smoothing/b_spline.hpp"
#include "kernels/smoothing/core_triangle.hpp"
#include "kernels/smoothing/cubic_spline.hpp"
#include "kernels/smoothing/density_apart.hpp"
#include "kernels/smoothing/hoct.hpp"
#include "kernels/smoothing/hydra.hpp"
#include "kernels/smoothing/johnson.hpp"
#include "kernels/smoothing/liq.hpp"
#include "kernels/smoothing/own_kernel.hpp"
#include "kernels/smoothing/wendland.hpp"

namespace sphk {

/// Every smoothing kernel. A new one is a file beside these and an entry here.
using SmoothingKernels = List<CubicSpline, CoreTriangle, CoreTriangleForces, Hoct<3>, Hoct<4>, Hoct<5>, Hoct<8>, Liq,
                              Hydra, Johnson, BSpline<5>, BSpline<6>, WendlandC2, WendlandC4, WendlandC6>;

/// Names of all smoothing kernels, in the order of the list; behind them those that modules have brought.
inline std::vector<std::string> smoothing_kernel_names() {
  std::vector<std::string> names;
  for_each_type(SmoothingKernels{}, [&]<class Kernel>() { names.emplace_back(Kernel::name); });
  for (const OwnKernel& own : own_kernels()) names.emplace_back(own.known_as);
  return names;
}

namespace detail {

/// The x_s of "liq0.4", or a negative number where `name` is no such thing.
inline double liq_core_edge(std::string_view name) {
  if (!name.starts_with("liq") || name.size() == 3) return -1;
  const std::string digits(name.substr(3));
  char* end = nullptr;
  const double x_s = std::strtod(digits.c_str(), &end);
  return *end == '\0' && x_s >= 0 && x_s < 1 ? x_s : -1;
}

template <class F, class Kernel, class... Rest>
decltype(auto) with_kernel_of(List<Kernel, Rest...>, std::string_view name, F&& f) {
  if (name == Kernel::name) return f(Kernel{});
  if constexpr (sizeof...(Rest) > 0) return with_kernel_of(List<Rest...>{}, name, f);
  for (const OwnKernel& own : own_kernels())
    if (name == own.known_as) return f(own);
  std::string known;
  for (const std::string& each : smoothing_kernel_names()) known += each + ", ";
  throw std::invalid_argument("there is no smoothing kernel \"" + std::string(name) + "\"; known are " + known +
                              "and liq with a core edge from 0 to 1, such as liq0.4");
}

}  // namespace detail

/// f(kernel) for the smoothing kernel of that name; "liq0.4" is LIQ with x_s = 0.4. f returns the same type for every
/// kernel. Host only. Throws std::invalid_argument with the known names.
template <class F>
decltype(auto) with_kernel(std::string_view name, F&& f) {
  if (const double x_s = detail::liq_core_edge(name); x_s >= 0) return f(Liq(x_s));
  return detail::with_kernel_of(SmoothingKernels{}, name, f);
}

}  // namespace sphk
