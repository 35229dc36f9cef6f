// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>
#include <cstdint>

namespace sphk {

/// Bits per axis of a space-filling curve's key: 63 in 3D, 62 in 2D, 62 in 1D.
template <int D>
inline constexpr int curve_bits = D == 3   ? 21
                                  : D == 2 ? 31
                                           : 62;

/// Position along the Hilbert curve of the lattice cell `a`, each coordinate below 2^curve_bits (Skilling 2004).
template <int D>
KOKKOS_INLINE_FUNCTION std::uint64_t hilbert_key(std::uint64_t* a) {
  constexpr int bits = curve_bits<D>;
  if constexpr (D == 1) return a[0];
  const std::uint64_t top = std::uint64_t(1) << (bits - 1);
  for (std::uint64_t q = top; q > 1; q >>= 1) {
    const std::uint64_t p = q - 1;
    for (int d = 0; d < D; ++d) {
      if (a[d] & q) {
        a[0] ^= p;
      } else {
        const std::uint64_t t = (a[0] ^ a[d]) & p;
        a[0] ^= t;
        a[d] ^= t;
      }
    }
  }
  for (int d = 1; d < D; ++d) a[d] ^= a[d - 1];
  std::uint64_t t = 0;
  for (std::uint64_t q = top; q > 1; q >>= 1)
    if (a[D - 1] & q) t ^= q - 1;
  for (int d = 0; d < D; ++d) a[d] ^= t;
  std::uint64_t key = 0;
  for (int b = bits - 1; b >= 0; --b)
    for (int d = 0; d < D; ++d) key = (key << 1) | ((a[d] >> b) & 1);
  return key;
}

}  // namespace sphk
