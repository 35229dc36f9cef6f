#pragma once

#include <array>
#include <bit>

#include "kernels/core/simd.hpp"

namespace sphk {

/// One bit a lane: lane 0 is the lowest. Of packs on a host alone.
KOKKOS_FORCEINLINE_FUNCTION unsigned mask_bits(bool mask) {
  return mask;
}
#if defined(KOKKOS_ARCH_AVX2) || defined(KOKKOS_ARCH_AVX512XEON)
template <class M>
inline unsigned mask_bits(const M& mask) {
#if defined(KOKKOS_ARCH_AVX512XEON)
  if constexpr (M::size() == 16)
    return static_cast<__mmask16>(mask);
  else
    return static_cast<__mmask8>(mask);
#else
  if constexpr (M::size() == 8)
    return static_cast<unsigned>(_mm256_movemask_ps(static_cast<__m256>(mask)));
  else
    return static_cast<unsigned>(_mm256_movemask_pd(static_cast<__m256d>(mask)));
#endif
}
#endif

/// The number of the lowest bit of a mask that has one.
KOKKOS_FORCEINLINE_FUNCTION int lowest_bit(unsigned bits) {
  return Kokkos::countr_zero(bits);
}

#if defined(KOKKOS_ARCH_AVX2) && !defined(KOKKOS_ARCH_AVX512XEON)
namespace detail {
/// For every mask of `lanes` lanes of `words` 32-bit words each: the words of the chosen lanes in order, then anything.
template <int lanes, int words>
constexpr auto compress_orders() {
  std::array<std::array<int, 8>, 1 << lanes> orders{};
  for (int mask = 0; mask < 1 << lanes; ++mask) {
    int to = 0;
    for (int lane = 0; lane < lanes; ++lane)
      for (int word = 0; word < words && (mask >> lane & 1); ++word) orders[mask][to++] = lane * words + word;
  }
  return orders;
}
alignas(64) inline constexpr auto compress_floats = compress_orders<8, 1>();
alignas(64) inline constexpr auto compress_doubles = compress_orders<4, 2>();
}  // namespace detail
#endif

/// Moves the chosen lanes of packs to the front, in order. Made once for a mask and used for many packs. A store writes
/// all lanes of a pack: what follows the chosen ones is to be overwritten.
template <class P>
class Compress {
 public:
  explicit Compress(unsigned bits) : bits_(bits) {
#if defined(KOKKOS_ARCH_AVX2) && !defined(KOKKOS_ARCH_AVX512XEON)
    if constexpr (lanes<P> == 8) order_ = load_order(detail::compress_floats[bits].data());
    if constexpr (lanes<P> == 4) order_ = load_order(detail::compress_doubles[bits].data());
#endif
  }
  int count() const {
    return std::popcount(bits_);
  }

  void store(lane_t<P>* to, const P& a) const {
    if constexpr (Scalar<P>) {
      if (bits_) *to = a;
#if defined(KOKKOS_ARCH_AVX512XEON)
    } else if constexpr (lanes<P> == 16) {  // to a register first: a compressing store to memory is microcoded on Zen 4
      _mm512_storeu_ps(to, _mm512_maskz_compress_ps(static_cast<__mmask16>(bits_), static_cast<__m512>(a)));
    } else if constexpr (std::is_same_v<lane_t<P>, float>) {
      _mm256_storeu_ps(to, _mm256_maskz_compress_ps(static_cast<__mmask8>(bits_), static_cast<__m256>(a)));
    } else {
      _mm512_storeu_pd(to, _mm512_maskz_compress_pd(static_cast<__mmask8>(bits_), static_cast<__m512d>(a)));
    }
#elif defined(KOKKOS_ARCH_AVX2)
    } else if constexpr (std::is_same_v<lane_t<P>, float>) {
      _mm256_storeu_ps(to, _mm256_permutevar8x32_ps(static_cast<__m256>(a), order_));
    } else {
      const __m256 words = _mm256_castpd_ps(static_cast<__m256d>(a));
      _mm256_storeu_pd(to, _mm256_castps_pd(_mm256_permutevar8x32_ps(words, order_)));
    }
#else
    }
#endif
  }

 private:
  unsigned bits_;
#if defined(KOKKOS_ARCH_AVX2) && !defined(KOKKOS_ARCH_AVX512XEON)
  static __m256i load_order(const int* order) {
    return _mm256_load_si256(reinterpret_cast<const __m256i*>(order));
  }
  __m256i order_{};
#endif
};

}  // namespace sphk
