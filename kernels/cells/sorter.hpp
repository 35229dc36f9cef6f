// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cells/domain.hpp"
#include "kernels/cells/hilbert.hpp"
#include "kernels/cells/radix_sort.hpp"

namespace sphk {

/// Particles of a block that is ordered as a kd tree after the sort along the Hilbert curve.
inline constexpr int block_size = 4096;

namespace detail {

/// Rows of numbers as long as `stride`; the first D hold positions.
struct PositionRows {
  double* x;
  std::size_t stride;
  KOKKOS_INLINE_FUNCTION double& operator()(int i, int d) const { return x[d * stride + i]; }
};

template <int D>
struct CurveKeys {
  PositionRows positions;
  Domain<D> domain;
  double lo[D], scale[D];  ///< (x - lo) * scale is in [0, 1]
  RadixSort::Keys keys;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    constexpr double cells = static_cast<double>(std::uint64_t(1) << curve_bits<D>);
    std::uint64_t a[D];
    for (int d = 0; d < D; ++d) {
      double& x = positions(i, d);
      x = domain.wrapped(x, d);
      const double cell = (x - lo[d]) * scale[d] * cells;
      a[d] = cell <= 0 ? 0 : static_cast<std::uint64_t>(min(cell, cells - 1));
    }
    keys(i) = hilbert_key<D>(a);
  }
};

/// Orders one block of particles so that every aligned run of 8 * 2^k of them has a compact box: median splits of the
/// longest axis, down to the sub-cells.
template <int D>
struct OrderBlock {
  PositionRows positions;
  RadixSort::Indices indices;
  int n;

  KOKKOS_INLINE_FUNCTION double x(int k, int d) const { return positions(indices(k), d); }

  KOKKOS_INLINE_FUNCTION int longest_axis(int begin, int end) const {
    int axis = 0;
    double longest = -1;
    for (int d = 0; d < D; ++d) {
      double lo = x(begin, d), hi = lo;
      for (int k = begin + 1; k < end; ++k) lo = min(lo, x(k, d)), hi = max(hi, x(k, d));
      if (hi - lo > longest) longest = hi - lo, axis = d;
    }
    return axis;
  }

  /// Quickselect: afterwards [begin, middle) is not above [middle, end) along the axis.
  KOKKOS_INLINE_FUNCTION void split(int begin, int middle, int end, int axis) const {
    int lo = begin, hi = end - 1;
    while (lo < hi) {
      const double pivot = x((lo + hi) / 2, axis);
      int a = lo - 1, b = hi + 1;
      while (true) {
        do ++a;
        while (x(a, axis) < pivot);
        do --b;
        while (x(b, axis) > pivot);
        if (a >= b) break;
        const int swapped = indices(a);
        indices(a) = indices(b);
        indices(b) = swapped;
      }
      if (middle <= b)
        hi = b;
      else
        lo = b + 1;
    }
  }

  KOKKOS_INLINE_FUNCTION void operator()(int block) const {
    const int first = block * block_size, last = min(first + block_size, n);
    for (int size = block_size; size > sub_cell_size; size /= 2)
      for (int begin = first; begin + size / 2 < last; begin += size) {
        const int end = min(begin + size, last);
        split(begin, begin + size / 2, end, longest_axis(begin, end));
      }
  }
};

template <class T>
struct GatherRow {
  const T* from;
  T* to;
  RadixSort::Indices indices;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const { to[i] = from[indices(i)]; }
};

template <class T>
struct CopyRow {
  const T* from;
  T* to;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const { to[i] = from[i]; }
};

}  // namespace detail

using Ids = Kokkos::View<std::uint64_t*, MemorySpace>;

/// Sorts particles in space so that aligned runs of 8, 64, 512, ... of them are compact: along the Hilbert curve, then
/// as a kd tree inside blocks. Wraps positions into the periodic box. Columns are permuted row by row, by way of the
/// memory in which the keys were sorted: there is no second copy of them, and nothing is allocated later.
template <int D>
class Sorter {
 public:
  static constexpr int rows = RadixSort::rows;  ///< of the memory that it works in

  Sorter() = default;
  /// For n particles. `memory`: `rows` rows of numbers, each `stride` long. They may be rows of the columns, those that
  /// nobody reads before they are computed anew; a sort leaves them without meaning.
  Sorter(int n, const ColumnNumbers& memory, int stride)
      : memory_(memory), sort_(n, memory.data(), static_cast<std::size_t>(stride)) {}

  /// The rows that it works in. Between two sorts they may serve others.
  const ColumnNumbers& memory() const { return memory_; }

  /// Puts a row, a value a particle of no more than 8 bytes, in the order of the last sort.
  template <class T>
  void permute(T* row) const {
    static_assert(sizeof(T) <= sizeof(double));
    const Kokkos::RangePolicy<ExecutionSpace> particles(0, sort_.indices.extent(0));
    T* spare = reinterpret_cast<T*>(memory_.data());  // where keys were
    Kokkos::parallel_for("sort: gather", particles, detail::GatherRow<T>{row, spare, sort_.indices});
    Kokkos::parallel_for("sort: put back", particles, detail::CopyRow<T>{spare, row});
  }

  /// `columns`: the numbers of the columns, whose first D rows are positions, each row `stride` long.
  void operator()(const ColumnNumbers& columns, int stride, const Ids& ids, const Domain<D>& domain,
                  const Bounds<D>& all) {
    const int n = static_cast<int>(ids.extent(0));
    if (n == 0) return;
    const detail::PositionRows positions{columns.data(), static_cast<std::size_t>(stride)};
    find_order(n, positions, domain, all);
    for (std::size_t start = 0; start < columns.extent(0); start += positions.stride) {
      double* row = columns.data() + start;
      if (!works_in(row)) permute(row);
    }
    permute(ids.data());
  }

 private:
  /// Leaves in `sort_.indices` where each particle of the new order is now.
  void find_order(int n, const detail::PositionRows& positions, const Domain<D>& domain, const Bounds<D>& all) {
    detail::CurveKeys<D> curve{positions, domain, {}, {}, sort_.keys};
    for (int d = 0; d < D; ++d) {
      curve.lo[d] = domain.period[d] > 0 ? domain.lower[d] : all.lo[d];
      const double size = domain.period[d] > 0 ? domain.period[d] : all.hi[d] - all.lo[d];
      curve.scale[d] = size > 0 ? 1 / size : 0;
    }
    Kokkos::parallel_for("sort: curve keys", Kokkos::RangePolicy<ExecutionSpace>(0, n), curve);
    sort_.sort();
    Kokkos::parallel_for("sort: kd order",
                         Kokkos::RangePolicy<ExecutionSpace, Kokkos::Schedule<Kokkos::Dynamic>>(
                             0, (n + block_size - 1) / block_size, Kokkos::ChunkSize(1)),
                         detail::OrderBlock<D>{positions, sort_.indices, n});
  }
  bool works_in(const double* row) const { return row >= memory_.data() && row < memory_.data() + memory_.extent(0); }

  ColumnNumbers memory_;
  RadixSort sort_;
};

}  // namespace sphk
