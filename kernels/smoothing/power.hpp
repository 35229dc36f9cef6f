// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/shape.hpp"

namespace sphk {

/// x^n, n >= 1, by repeated squaring.
template <int n, class T>
KOKKOS_FORCEINLINE_FUNCTION constexpr T power(T x) {
  static_assert(n >= 1);
  if constexpr (n == 1)
    return x;
  else if constexpr (n % 2 == 0)
    return power<n / 2>(x * x);
  else
    return x * power<n - 1>(x);
}

/// Products in power<n>.
constexpr int power_flops(int n) {
  return n == 1 ? 0 : n % 2 == 0 ? 1 + power_flops(n / 2) : 1 + power_flops(n - 1);
}

/// max(edge - q, 0): a branch-free mask, since every positive power of it vanishes smoothly at the edge.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION T truncated(lane_t<T> edge, T q) {
  return sphk::max(edge - q, T(lane_t<T>(0)));
}

/// Two inner truncated powers, c (b - q)_+^n, beside (1 - q)_+^n.
struct InnerPowers {
  double b1, c1, b2, c2;
};

/// (1-q)_+^n + c1 (b1-q)_+^n + c2 (b2-q)_+^n and its derivative, with shared powers.
template <int n, class T>
KOKKOS_FORCEINLINE_FUNCTION Shape<T> truncated_powers(T q, const InnerPowers& inner) {
  using R = lane_t<T>;
  const T s0 = truncated(R(1), q), s1 = truncated(R(inner.b1), q), s2 = truncated(R(inner.b2), q);
  const T p0 = power<n - 1>(s0), p1 = power<n - 1>(s1), p2 = power<n - 1>(s2);
  const R c1 = R(inner.c1), c2 = R(inner.c2);
  return {s0 * p0 + c1 * (s1 * p1) + c2 * (s2 * p2), R(-n) * (p0 + c1 * p1 + c2 * p2)};
}

/// The value alone: an even power is cheaper than an odd one times its base.
template <int n, class T>
KOKKOS_FORCEINLINE_FUNCTION T truncated_powers_w(T q, const InnerPowers& inner) {
  using R = lane_t<T>;
  const T s0 = truncated(R(1), q), s1 = truncated(R(inner.b1), q), s2 = truncated(R(inner.b2), q);
  return power<n>(s0) + R(inner.c1) * power<n>(s1) + R(inner.c2) * power<n>(s2);
}

/// Operations of truncated_powers<n>.
constexpr int truncated_powers_flops(int n) {
  return 18 + 3 * power_flops(n - 1);
}

}  // namespace sphk
