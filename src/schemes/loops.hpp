// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tuple>

#include "src/schemes/shared_loops.hpp"

namespace sphk {

template <class S>
SupportCounts find_support_apart(const State<S>& state, const Given& given, double accept) {
  return find_support(state, given, accept);
}
template <class S>
FitCounts fit_velocities_apart(const State<S>& state) {
  return fit_velocities(state);
}

namespace detail {

template <class L, int D, class T, class... K>
constexpr auto density_of(List<K...>) {
  return std::tuple{&find_support_apart<CoreScheme<typename L::template Layout<D>, K, T, typename L::Sums>>...};
}
template <class L, int D, class T, class... K>
constexpr auto gradients_of(List<K...>) {
  if constexpr (L::has_gradients)
    return std::tuple{&fit_velocities_apart<CoreScheme<typename L::template Layout<D>, K, T, typename L::Sums>>...};
  else
    return std::tuple{};
}

}  // namespace detail

/// Addresses of all shared loops in D dimensions with pair arithmetic in T, which makes the compiler write them.
template <int D, class T, class... L>
constexpr auto density_loops(List<L...>) {
  return std::tuple_cat(detail::density_of<L, D, T>(typename L::template Kernel<D>{})...);
}
template <int D, class T, class... L>
constexpr auto gradient_loops(List<L...>) {
  return std::tuple_cat(detail::gradients_of<L, D, T>(typename L::template Kernel<D>{})...);
}

}  // namespace sphk
