// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>
#include <Kokkos_SIMD.hpp>
#include <cstring>

namespace sphk {

namespace stdx = Kokkos::Experimental;

/// Names packs of W numbers for hosts for which Kokkos has none: vectors as g++ and clang know them, whatever the
/// processor calls them.
template <int W>
struct VectorAbi {};

}  // namespace sphk

// Builds for GPUs, whose compilers need not know such vectors, have none.
#if !defined(KOKKOS_ENABLE_CUDA) && !defined(KOKKOS_ENABLE_HIP) && !defined(KOKKOS_ENABLE_SYCL)
#define SPHK_VECTOR_PACKS

// As much of Kokkos' interface as simd.hpp and what Kokkos builds on it (a + 1, a += b, sqrt) ask for.
namespace Kokkos::Experimental {

template <class T, int W>
class basic_simd_mask<T, sphk::VectorAbi<W>> {
 public:
  typedef T Numbers __attribute__((vector_size(W * sizeof(T))));
  using Vector = decltype(Numbers{} < Numbers{});
  static constexpr std::size_t size() { return W; }
  KOKKOS_FORCEINLINE_FUNCTION explicit basic_simd_mask(Vector lanes) : lanes_(lanes) {}
  KOKKOS_FORCEINLINE_FUNCTION explicit operator Vector() const { return lanes_; }
  KOKKOS_FORCEINLINE_FUNCTION bool operator[](std::size_t lane) const { return lanes_[lane] != 0; }

 private:
  Vector lanes_;
};

template <class T, int W>
class basic_simd<T, sphk::VectorAbi<W>> {
 public:
  using value_type = T;
  using abi_type = sphk::VectorAbi<W>;
  using mask_type = basic_simd_mask<T, abi_type>;
  using Vector = typename mask_type::Numbers;
  static constexpr std::size_t size() { return W; }

  basic_simd() = default;
  template <class U>
  requires std::is_arithmetic_v<U> KOKKOS_FORCEINLINE_FUNCTION basic_simd(U value)
      : lanes_(Vector{} + static_cast<T>(value)) {}
  KOKKOS_FORCEINLINE_FUNCTION explicit basic_simd(Vector lanes) : lanes_(lanes) {}
  KOKKOS_FORCEINLINE_FUNCTION basic_simd(const T* from, simd_flags<> flags) { copy_from(from, flags); }
  KOKKOS_FORCEINLINE_FUNCTION void copy_from(const T* from, simd_flags<>) { std::memcpy(&lanes_, from, sizeof lanes_); }
  KOKKOS_FORCEINLINE_FUNCTION void copy_to(T* to, simd_flags<>) const { std::memcpy(to, &lanes_, sizeof lanes_); }
  KOKKOS_FORCEINLINE_FUNCTION explicit operator Vector() const { return lanes_; }
  KOKKOS_FORCEINLINE_FUNCTION T operator[](std::size_t lane) const { return lanes_[lane]; }

  KOKKOS_FORCEINLINE_FUNCTION basic_simd operator-() const { return basic_simd(-lanes_); }
  KOKKOS_FORCEINLINE_FUNCTION friend basic_simd operator+(const basic_simd& a, const basic_simd& b) {
    return basic_simd(a.lanes_ + b.lanes_);
  }
  KOKKOS_FORCEINLINE_FUNCTION friend basic_simd operator-(const basic_simd& a, const basic_simd& b) {
    return basic_simd(a.lanes_ - b.lanes_);
  }
  KOKKOS_FORCEINLINE_FUNCTION friend basic_simd operator*(const basic_simd& a, const basic_simd& b) {
    return basic_simd(a.lanes_ * b.lanes_);
  }
  KOKKOS_FORCEINLINE_FUNCTION friend basic_simd operator/(const basic_simd& a, const basic_simd& b) {
    return basic_simd(a.lanes_ / b.lanes_);
  }
  KOKKOS_FORCEINLINE_FUNCTION friend mask_type operator<(const basic_simd& a, const basic_simd& b) {
    return mask_type(a.lanes_ < b.lanes_);
  }
  KOKKOS_FORCEINLINE_FUNCTION friend mask_type operator<=(const basic_simd& a, const basic_simd& b) {
    return mask_type(a.lanes_ <= b.lanes_);
  }

 private:
  Vector lanes_;
};

template <class T, int W>
KOKKOS_FORCEINLINE_FUNCTION basic_simd<T, sphk::VectorAbi<W>> condition(
    const basic_simd_mask<T, sphk::VectorAbi<W>>& mask, const basic_simd<T, sphk::VectorAbi<W>>& yes,
    const basic_simd<T, sphk::VectorAbi<W>>& no) {
  using Pack = basic_simd<T, sphk::VectorAbi<W>>;
  using Numbers = typename Pack::Vector;
  using Mask = typename Pack::mask_type::Vector;
  return Pack(static_cast<Mask>(mask) ? static_cast<Numbers>(yes) : static_cast<Numbers>(no));
}

}  // namespace Kokkos::Experimental

namespace Kokkos {

template <class T, int W>
KOKKOS_FORCEINLINE_FUNCTION auto max(const Experimental::basic_simd<T, sphk::VectorAbi<W>>& a,
                                     const Experimental::basic_simd<T, sphk::VectorAbi<W>>& b) {
  return condition(a < b, b, a);
}
template <class T, int W>
KOKKOS_FORCEINLINE_FUNCTION auto min(const Experimental::basic_simd<T, sphk::VectorAbi<W>>& a,
                                     const Experimental::basic_simd<T, sphk::VectorAbi<W>>& b) {
  return condition(b < a, b, a);
}
template <class T, int W>
KOKKOS_FORCEINLINE_FUNCTION auto abs(const Experimental::basic_simd<T, sphk::VectorAbi<W>>& a) {
  return Kokkos::max(a, -a);
}

}  // namespace Kokkos

#endif
