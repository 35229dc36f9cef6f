// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>

#include "kernels/core/vector_pack.hpp"

/// Behind the parameters of a lambda: compilers leave bodies of loops that are called from two places out of line, and
/// pass packs through memory.
#define SPHK_ALWAYS_INLINE __attribute__((always_inline))

namespace sphk {

/// The host's vector registers: the bytes of one, 0 where there are no packs for it, and how many they are.
#if defined(KOKKOS_ARCH_AVX512XEON)
inline constexpr int register_bytes = 64, host_registers = 32;
template <class T, int W>
using PackAbi = stdx::simd_abi::avx512_fixed_size<W>;
#elif defined(KOKKOS_ARCH_AVX2)
inline constexpr int register_bytes = 32, host_registers = 16;
template <class T, int W>
using PackAbi = stdx::simd_abi::avx2_fixed_size<W>;
#elif defined(KOKKOS_ARCH_ARM_NEON) || defined(KOKKOS_ARCH_ARM_SVE)  // a host with SVE has NEON
inline constexpr int register_bytes = 16, host_registers = 32;
template <class T, int W>
using PackAbi = stdx::simd_abi::neon_fixed_size<W>;
#elif defined(SPHK_VECTOR_PACKS) && (defined(__SSE2__) || defined(__VSX__) || defined(__ARM_NEON))
inline constexpr int register_bytes = 16, host_registers = 16;
template <class T, int W>
using PackAbi = VectorAbi<W>;
#else
inline constexpr int register_bytes = 0, host_registers = 16;
template <class T, int W>
using PackAbi = VectorAbi<W>;
#endif

/// Lanes of T that one register of the host holds; 1 where there are no packs for it.
template <class T>
inline constexpr int native_lanes = register_bytes == 0 ? 1 : register_bytes / static_cast<int>(sizeof(T));

namespace detail {
template <class T, int W>
struct SimdType {
  using type = stdx::basic_simd<T, PackAbi<T, W>>;
};
template <class T>
struct SimdType<T, 1> {
  using type = T;
};
}  // namespace detail

/// W numbers of type T side by side; simd<T, 1> is T itself, which is what a GPU thread uses. Compare them with < and
/// <= alone: > and >= of eight doubles are the wrong way round in Kokkos 4.7.0 with AVX-512.
template <class T, int W>
using simd = typename detail::SimdType<T, W>::type;

template <class T>
concept Scalar = std::is_arithmetic_v<T>;

namespace detail {
template <class P>
struct LaneType {
  using type = typename P::value_type;
};
template <Scalar T>
struct LaneType<T> {
  using type = T;
};
}  // namespace detail

/// The number type of one lane.
template <class P>
using lane_t = typename detail::LaneType<P>::type;

template <class P>
inline constexpr int lanes = [] {
  if constexpr (Scalar<P>)
    return 1;
  else
    return static_cast<int>(P::size());
}();

template <Scalar T>
KOKKOS_FORCEINLINE_FUNCTION T max(T a, T b) {
  return a < b ? b : a;
}
template <Scalar T>
KOKKOS_FORCEINLINE_FUNCTION T min(T a, T b) {
  return b < a ? b : a;
}
template <Scalar T>
KOKKOS_FORCEINLINE_FUNCTION T abs(T a) {
  return a < T(0) ? -a : a;
}
template <Scalar T>
KOKKOS_FORCEINLINE_FUNCTION T sqrt(T a) {
  return Kokkos::sqrt(a);
}
template <Scalar T>
KOKKOS_FORCEINLINE_FUNCTION T select(bool condition, T yes, T no) {
  return condition ? yes : no;
}
template <Scalar T>
KOKKOS_FORCEINLINE_FUNCTION T sum_lanes(T a) {
  return a;
}
template <Scalar T>
KOKKOS_FORCEINLINE_FUNCTION T max_lanes(T a) {
  return a;
}

template <class T, class A>
KOKKOS_FORCEINLINE_FUNCTION stdx::basic_simd<T, A> max(const stdx::basic_simd<T, A>& a,
                                                       const std::type_identity_t<stdx::basic_simd<T, A>>& b) {
  return Kokkos::max(a, b);
}
template <class T, class A>
KOKKOS_FORCEINLINE_FUNCTION stdx::basic_simd<T, A> min(const stdx::basic_simd<T, A>& a,
                                                       const std::type_identity_t<stdx::basic_simd<T, A>>& b) {
  return Kokkos::min(a, b);
}
template <class T, class A>
KOKKOS_FORCEINLINE_FUNCTION stdx::basic_simd<T, A> abs(const stdx::basic_simd<T, A>& a) {
  return Kokkos::abs(a);
}
template <class T, class A>
KOKKOS_FORCEINLINE_FUNCTION stdx::basic_simd<T, A> sqrt(const stdx::basic_simd<T, A>& a) {
  return Kokkos::sqrt(a);
}
template <class T, class A>
KOKKOS_FORCEINLINE_FUNCTION stdx::basic_simd<T, A> select(const stdx::basic_simd_mask<T, A>& condition,
                                                          const std::type_identity_t<stdx::basic_simd<T, A>>& yes,
                                                          const std::type_identity_t<stdx::basic_simd<T, A>>& no) {
  return stdx::condition(condition, yes, no);
}

template <class T, class A>
KOKKOS_FORCEINLINE_FUNCTION void store(T* to, const stdx::basic_simd<T, A>& a) {
  a.copy_to(to, stdx::simd_flag_default);
}
template <Scalar T>
KOKKOS_FORCEINLINE_FUNCTION void store(T* to, T a) {
  *to = a;
}

/// Reads lanes<P> numbers from any address.
template <class P>
KOKKOS_FORCEINLINE_FUNCTION P load(const lane_t<P>* from) {
  if constexpr (Scalar<P>)
    return *from;
  else
    return P(from, stdx::simd_flag_default);
}

namespace detail {

struct Add {
  template <class T>
  T operator()(T a, T b) const {
    return a + b;
  }
};
struct Max {
  template <class T>
  T operator()(T a, T b) const {
    return max(a, b);
  }
#if defined(KOKKOS_ARCH_AVX2) || defined(KOKKOS_ARCH_AVX512XEON)
  __m128 operator()(__m128 a, __m128 b) const {
    return _mm_max_ps(b, a);
  }
  __m256 operator()(__m256 a, __m256 b) const {
    return _mm256_max_ps(b, a);
  }
  __m128d operator()(__m128d a, __m128d b) const {
    return _mm_max_pd(b, a);
  }
  __m256d operator()(__m256d a, __m256d b) const {
    return _mm256_max_pd(b, a);
  }
#endif
};

// Folds the upper half of the lanes onto the lower one until one is left. Compilers keep loops over the lanes of a pack
// in memory as loops.
template <class T, class Op>
T fold(const T* lane, int width, const Op& op) {
  T folded[16];
  for (int k = 0; k < width; ++k) folded[k] = lane[k];
  for (int half = width / 2; half > 0; half /= 2)
    for (int k = 0; k < half; ++k) folded[k] = op(folded[k], folded[k + half]);
  return folded[0];
}
#if defined(KOKKOS_ARCH_AVX2) || defined(KOKKOS_ARCH_AVX512XEON)
template <class Op>
float fold(__m256 a, const Op& op) {
  __m128 b = op(_mm256_castps256_ps128(a), _mm256_extractf128_ps(a, 1));
  b = op(b, _mm_movehl_ps(b, b));
  return _mm_cvtss_f32(op(b, _mm_shuffle_ps(b, b, 1)));
}
template <class Op>
double fold(__m256d a, const Op& op) {
  const __m128d b = op(_mm256_castpd256_pd128(a), _mm256_extractf128_pd(a, 1));
  return _mm_cvtsd_f64(op(b, _mm_unpackhi_pd(b, b)));
}
#endif
#if defined(KOKKOS_ARCH_AVX512XEON)
template <class Op>
float fold(__m512 a, const Op& op) {
  return fold(op(_mm512_castps512_ps256(a), _mm512_extractf32x8_ps(a, 1)), op);
}
template <class Op>
double fold(__m512d a, const Op& op) {
  return fold(op(_mm512_castpd512_pd256(a), _mm512_extractf64x4_pd(a, 1)), op);
}
#endif

template <class T, class A, class Op>
T fold_lanes(const stdx::basic_simd<T, A>& a, const Op& op) {
#if defined(KOKKOS_ARCH_AVX512XEON)
  if constexpr (sizeof(a) == 64 && sizeof(T) == 4) return fold(static_cast<__m512>(a), op);
  if constexpr (sizeof(a) == 64 && sizeof(T) == 8) return fold(static_cast<__m512d>(a), op);
#endif
#if defined(KOKKOS_ARCH_AVX2) || defined(KOKKOS_ARCH_AVX512XEON)
  if constexpr (sizeof(a) == 32 && sizeof(T) == 4) return fold(static_cast<__m256>(a), op);
  if constexpr (sizeof(a) == 32 && sizeof(T) == 8) return fold(static_cast<__m256d>(a), op);
#endif
  constexpr int width = static_cast<int>(stdx::basic_simd<T, A>::size());
  T lane[width];
  store(lane, a);
  return fold(lane, width, op);
}

}  // namespace detail

/// The sum over the lanes, in a fixed order.
template <class T, class A>
KOKKOS_FORCEINLINE_FUNCTION T sum_lanes(const stdx::basic_simd<T, A>& a) {
  return detail::fold_lanes(a, detail::Add{});
}

template <class T, class A>
KOKKOS_FORCEINLINE_FUNCTION T max_lanes(const stdx::basic_simd<T, A>& a) {
  return detail::fold_lanes(a, detail::Max{});
}

}  // namespace sphk
