// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <bit>
#include <cstdint>

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
#elif defined(KOKKOS_ARCH_ARM_NEON) || defined(KOKKOS_ARCH_ARM_SVE)
inline unsigned mask_bits(const simd<float, 4>::mask_type& mask) {
  constexpr uint32x4_t bits = {1, 2, 4, 8};
  return vaddvq_u32(vandq_u32(static_cast<uint32x4_t>(mask), bits));
}
inline unsigned mask_bits(const simd<double, 2>::mask_type& mask) {
  constexpr uint64x2_t bits = {1, 2};
  return static_cast<unsigned>(vaddvq_u64(vandq_u64(static_cast<uint64x2_t>(mask), bits)));
}
#endif
#ifdef SPHK_VECTOR_PACKS
template <class T, int W>
inline unsigned mask_bits(const stdx::basic_simd_mask<T, VectorAbi<W>>& mask) {
#ifdef __SSE2__
  using Mask = stdx::basic_simd_mask<T, VectorAbi<W>>;
  const auto numbers = (typename Mask::Numbers) static_cast<typename Mask::Vector>(mask);
  if constexpr (W == 4)
    return static_cast<unsigned>(__builtin_ia32_movmskps(numbers));
  else
    return static_cast<unsigned>(__builtin_ia32_movmskpd(numbers));
#else
  unsigned bits = 0;
  for (int lane = 0; lane < W; ++lane) bits |= unsigned(mask[static_cast<std::size_t>(lane)]) << lane;
  return bits;
#endif
}
#endif

/// The number of the lowest bit of a mask that has one.
KOKKOS_FORCEINLINE_FUNCTION int lowest_bit(unsigned bits) {
  return Kokkos::countr_zero(bits);
}

namespace detail {
/// For every mask of `lanes` lanes of a register of `pieces` pieces: the pieces of the chosen lanes in order, then
/// anything.
template <class Piece, int pieces, int lanes>
constexpr auto compress_orders() {
  constexpr int each = pieces / lanes;
  std::array<std::array<Piece, pieces>, 1 << lanes> orders{};
  for (int mask = 0; mask < 1 << lanes; ++mask) {
    int to = 0;
    for (int lane = 0; lane < lanes; ++lane)
      for (int piece = 0; piece < each && (mask >> lane & 1); ++piece)
        orders[mask][to++] = static_cast<Piece>(lane * each + piece);
  }
  return orders;
}
#if defined(KOKKOS_ARCH_AVX2) && !defined(KOKKOS_ARCH_AVX512XEON)
alignas(64) inline constexpr auto compress_floats = compress_orders<int, 8, 8>();
alignas(64) inline constexpr auto compress_doubles = compress_orders<int, 8, 4>();
#elif defined(KOKKOS_ARCH_ARM_NEON) || defined(KOKKOS_ARCH_ARM_SVE)
template <int lanes>
alignas(64) inline constexpr auto compress_bytes = compress_orders<std::uint8_t, 16, lanes>();
#endif
}  // namespace detail

/// Moves the chosen lanes of packs to the front, in order. Made once for a mask and used for many packs. A store may
/// write all lanes of a pack: what follows the chosen ones is to be overwritten.
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

#if defined(KOKKOS_ARCH_ARM_NEON) || defined(KOKKOS_ARCH_ARM_SVE)
template <class T, int W>
class Compress<stdx::basic_simd<T, stdx::simd_abi::neon_fixed_size<W>>> {
 public:
  explicit Compress(unsigned bits) : bits_(bits), order_(vld1q_u8(detail::compress_bytes<W>[bits].data())) {}
  int count() const { return std::popcount(bits_); }
  void store(float* to, const simd<float, 4>& a) const {
    vst1q_f32(to, vreinterpretq_f32_u8(chosen(vreinterpretq_u8_f32(static_cast<float32x4_t>(a)))));
  }
  void store(double* to, const simd<double, 2>& a) const {
    vst1q_f64(to, vreinterpretq_f64_u8(chosen(vreinterpretq_u8_f64(static_cast<float64x2_t>(a)))));
  }

 private:
  uint8x16_t chosen(uint8x16_t bytes) const { return vqtbl1q_u8(bytes, order_); }
  unsigned bits_;
  uint8x16_t order_;
};
#endif

#ifdef SPHK_VECTOR_PACKS
template <class T, int W>
class Compress<stdx::basic_simd<T, VectorAbi<W>>> {
 public:
  explicit Compress(unsigned bits) : bits_(bits) {}
  int count() const { return std::popcount(bits_); }
  /// Lane after lane, the next over what was not chosen: no branches.
  void store(T* to, const stdx::basic_simd<T, VectorAbi<W>>& a) const {
    for (int lane = 0; lane < W; ++lane) {
      *to = a[static_cast<std::size_t>(lane)];
      to += bits_ >> lane & 1;
    }
  }

 private:
  unsigned bits_;
};
#endif

}  // namespace sphk
