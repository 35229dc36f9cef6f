#pragma once

#include <type_traits>

#include "kernels/core/vector_pack.hpp"

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

/// The sum over the lanes, in a fixed order.
template <class T, class A>
KOKKOS_FORCEINLINE_FUNCTION T sum_lanes(const stdx::basic_simd<T, A>& a) {
  constexpr int width = static_cast<int>(stdx::basic_simd<T, A>::size());
  T lane[width];
  store(lane, a);
  for (int half = width / 2; half > 0; half /= 2)
    for (int k = 0; k < half; ++k) lane[k] += lane[k + half];
  return lane[0];
}

template <class T, class A>
KOKKOS_FORCEINLINE_FUNCTION T max_lanes(const stdx::basic_simd<T, A>& a) {
  constexpr int width = static_cast<int>(stdx::basic_simd<T, A>::size());
  T lane[width];
  store(lane, a);
  for (int half = width / 2; half > 0; half /= 2)
    for (int k = 0; k < half; ++k) lane[k] = max(lane[k], lane[k + half]);
  return lane[0];
}

}  // namespace sphk
