// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>
#include <cstdint>

#include "kernels/core/columns.hpp"

namespace sphk {

/// Stable parallel sort of (key, index) pairs by 8-bit digits, least significant first. Only the digits in which the
/// keys differ are sorted. The result does not depend on the number of threads.
class RadixSort {
 public:
  using Keys = Kokkos::View<std::uint64_t*, MemorySpace>;
  using Indices = Kokkos::View<int*, MemorySpace>;
  static constexpr int rows = 3;  ///< of memory that a sort works in, 8 bytes a key each

  RadixSort() = default;
  /// For n keys, in memory that must outlive this: `rows` rows, each `stride` >= n numbers long.
  RadixSort(int n, double* memory, std::size_t stride)
      : keys(reinterpret_cast<std::uint64_t*>(memory), n),
        indices(reinterpret_cast<int*>(memory + 2 * stride), n),
        other_keys_(reinterpret_cast<std::uint64_t*>(memory + stride), n),
        other_indices_(indices.data() + stride, n),
        blocks_((n + block_size - 1) / block_size),
        counts_("sort counts", digits * (n == 0 ? 1 : blocks_)) {}

  Keys keys;        ///< in: the keys; out: sorted
  Indices indices;  ///< out: where each sorted key came from

  void sort();

  static constexpr int block_size = 8192;
  static constexpr int digits = 256;

 private:
  Keys other_keys_;
  Indices other_indices_;
  int blocks_ = 0;
  Kokkos::View<int*, MemorySpace> counts_;  ///< [digit][block]
};

namespace detail {

struct DigitCount {
  RadixSort::Keys keys;
  Kokkos::View<int*, MemorySpace> counts;
  int blocks, shift;
  KOKKOS_INLINE_FUNCTION void operator()(int block) const {
    int histogram[RadixSort::digits] = {};
    const int begin = block * RadixSort::block_size;
    const int end = min(begin + RadixSort::block_size, static_cast<int>(keys.extent(0)));
    for (int i = begin; i < end; ++i) ++histogram[(keys(i) >> shift) & 255];
    for (int digit = 0; digit < RadixSort::digits; ++digit) counts(digit * blocks + block) = histogram[digit];
  }
};

struct DigitScan {
  Kokkos::View<int*, MemorySpace> counts;
  KOKKOS_INLINE_FUNCTION void operator()(int k, int& sum, bool final) const {
    const int count = counts(k);
    if (final) counts(k) = sum;
    sum += count;
  }
};

struct DigitScatter {
  RadixSort::Keys keys, to_keys;
  RadixSort::Indices indices, to_indices;
  Kokkos::View<int*, MemorySpace> counts;
  int blocks, shift;
  KOKKOS_INLINE_FUNCTION void operator()(int block) const {
    int next[RadixSort::digits];
    for (int digit = 0; digit < RadixSort::digits; ++digit) next[digit] = counts(digit * blocks + block);
    const int begin = block * RadixSort::block_size;
    const int end = min(begin + RadixSort::block_size, static_cast<int>(keys.extent(0)));
    for (int i = begin; i < end; ++i) {
      const int to = next[(keys(i) >> shift) & 255]++;
      to_keys(to) = keys(i);
      to_indices(to) = indices(i);
    }
  }
};

struct VaryingBits {
  RadixSort::Keys keys;
  KOKKOS_INLINE_FUNCTION void operator()(int i, std::uint64_t& bits) const { bits |= keys(i) ^ keys(0); }
};

struct FillIndices {
  RadixSort::Indices indices;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const { indices(i) = i; }
};

}  // namespace detail

inline void RadixSort::sort() {
  const int n = static_cast<int>(keys.extent(0));
  if (n == 0) return;
  const Kokkos::RangePolicy<ExecutionSpace> all(0, n), each_block(0, blocks_);
  std::uint64_t varying = 0;
  Kokkos::parallel_for("sort: indices", all, detail::FillIndices{indices});
  Kokkos::parallel_reduce("sort: varying bits", all, detail::VaryingBits{keys}, Kokkos::BOr<std::uint64_t>(varying));
  for (int shift = 0; shift < 64; shift += 8) {
    if (((varying >> shift) & 255) == 0) continue;
    Kokkos::parallel_for("sort: count", each_block, detail::DigitCount{keys, counts_, blocks_, shift});
    Kokkos::parallel_scan("sort: scan", Kokkos::RangePolicy<ExecutionSpace>(0, digits * blocks_),
                          detail::DigitScan{counts_});
    Kokkos::parallel_for("sort: scatter", each_block,
                         detail::DigitScatter{keys, other_keys_, indices, other_indices_, counts_, blocks_, shift});
    std::swap(keys, other_keys_);
    std::swap(indices, other_indices_);
  }
}

}  // namespace sphk
