// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/core/simd.hpp"

namespace sphk {

/// A vector of D numbers or packs.
template <class T, int D>
struct Vec {
  T c[D];

  KOKKOS_FORCEINLINE_FUNCTION T& operator[](int k) { return c[k]; }
  KOKKOS_FORCEINLINE_FUNCTION const T& operator[](int k) const { return c[k]; }

  KOKKOS_FORCEINLINE_FUNCTION Vec& operator+=(const Vec& b) {
    for (int k = 0; k < D; ++k) c[k] = c[k] + b.c[k];
    return *this;
  }
  KOKKOS_FORCEINLINE_FUNCTION Vec& operator-=(const Vec& b) {
    for (int k = 0; k < D; ++k) c[k] = c[k] - b.c[k];
    return *this;
  }
  friend KOKKOS_FORCEINLINE_FUNCTION Vec operator+(Vec a, const Vec& b) { return a += b; }
  friend KOKKOS_FORCEINLINE_FUNCTION Vec operator-(Vec a, const Vec& b) { return a -= b; }
  friend KOKKOS_FORCEINLINE_FUNCTION Vec operator*(const T& s, Vec a) {
    for (int k = 0; k < D; ++k) a.c[k] = s * a.c[k];
    return a;
  }
};

template <class T, int D>
KOKKOS_FORCEINLINE_FUNCTION T dot(const Vec<T, D>& a, const Vec<T, D>& b) {
  T sum = a[0] * b[0];
  for (int k = 1; k < D; ++k) sum = sum + a[k] * b[k];
  return sum;
}

template <class T, int D>
KOKKOS_FORCEINLINE_FUNCTION T length(const Vec<T, D>& a) {
  return sphk::sqrt(dot(a, a));
}

/// Components of a curl: 3 in 3D, the z component in 2D, none (kept as one zero) in 1D.
template <int D>
inline constexpr int curl_size = D == 3 ? 3 : 1;

/// a x b: three components in 3D, the z component in 2D, zero in 1D.
template <class T, int D>
KOKKOS_FORCEINLINE_FUNCTION Vec<T, curl_size<D>> cross(const Vec<T, D>& a, const Vec<T, D>& b) {
  if constexpr (D == 3)
    return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
  else if constexpr (D == 2)
    return {{a[0] * b[1] - a[1] * b[0]}};
  else
    return {{T(0)}};
}

}  // namespace sphk
