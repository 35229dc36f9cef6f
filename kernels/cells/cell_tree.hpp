// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cells/domain.hpp"
#include "kernels/core/columns.hpp"
#include "kernels/core/compress.hpp"

namespace sphk {

inline constexpr int cell_size = 64;  ///< particles of a cell: 8 sub-cells
inline constexpr int fan_out = 8;     ///< children of a node
inline constexpr int max_levels = 12;

/// Pair loops run over tiles on the host and with one thread per particle on a GPU.
inline constexpr bool tiles_pay = Kokkos::SpaceAccessibility<Kokkos::HostSpace, MemorySpace>::accessible;

/// Bounding boxes over sorted particles. A node of level l covers the particles [k 8^(l+1), (k+1) 8^(l+1)): level 0 are
/// sub-cells, level 1 cells, and so on up to a top level of at most 8 nodes. The order of the particles makes them
/// compact. The boxes of a node's children lie together, one component of all after the other.
template <int D>
class CellTree {
 public:
  int n = 0;
  int levels = 0;
  int first[max_levels + 1] = {};            ///< where each level starts among the nodes: at a multiple of fan_out
  Kokkos::View<Bounds<D>, MemorySpace> all;  ///< where bounds_of_all() puts its result
  Domain<D> domain{};

  CellTree() = default;
  CellTree(int particles, const Domain<D>& box) : n(particles), domain(box) {
    int count = (n + sub_cell_size - 1) / sub_cell_size, total = 0;
    while (true) {
      counts_[levels] = count;
      first[levels++] = total;
      const int families = (count + fan_out - 1) / fan_out;
      total += families * fan_out;
      if (levels >= 2 && families <= 1) break;
      count = families;
    }
    first[levels] = total;
    nodes_ = Kokkos::View<double*, MemorySpace>("cell tree", static_cast<std::size_t>(total) * node_rows);
    all = Kokkos::View<Bounds<D>, MemorySpace>("cell tree, all");
  }

  KOKKOS_INLINE_FUNCTION int count(int level) const { return counts_[level]; }
  /// All boxes as one array.
  const auto& nodes() const { return nodes_; }
  KOKKOS_INLINE_FUNCTION int cells() const { return (n + cell_size - 1) / cell_size; }
  KOKKOS_INLINE_FUNCTION Bounds<D> node(int level, int k) const {
    const double* at = node_of(level, k);
    Bounds<D> b;
    for (int d = 0; d < D; ++d) b.lo[d] = at[d * fan_out], b.hi[d] = at[(D + d) * fan_out];
    b.h_max = at[2 * D * fan_out];
    return b;
  }
  KOKKOS_INLINE_FUNCTION void set_node(int level, int k, const Bounds<D>& b) const {
    double* at = node_of(level, k);
    for (int d = 0; d < D; ++d) at[d * fan_out] = b.lo[d], at[(D + d) * fan_out] = b.hi[d];
    at[2 * D * fan_out] = b.h_max;
  }

  /// A bit for each of the 8 nodes from `begin` on, children of one: does its box, moved by `shift`, come nearer to
  /// `target` than reach(h_max)?
  template <class Reach>
  KOKKOS_INLINE_FUNCTION unsigned near(int level, int begin, const Bounds<D>& target, const double* shift,
                                       const Reach& reach) const {
    constexpr int width = tiles_pay ? native_lanes<double> : 1;
    using P = simd<double, width>;
    const int count = min(fan_out, this->count(level) - begin);
    unsigned bits = 0;
    for (int k = 0; k < fan_out; k += width) {
      const auto row = [&](int component) { return load<P>(node_of(level, begin + k) + component * fan_out); };
      P distance2 = P(0.0);
      for (int d = 0; d < D; ++d) {
        const P above = row(d) - P(target.hi[d] - shift[d]), below = P(target.lo[d] - shift[d]) - row(D + d);
        const P gap = sphk::max(sphk::max(above, below), P(0.0));
        distance2 = distance2 + gap * gap;
      }
      const P distance = reach(row(2 * D));
      bits |= mask_bits(distance2 < distance * distance) << k;
    }
    return bits & ((1u << count) - 1);
  }

 private:
  static constexpr int node_rows = 2 * D + 1;  ///< lo, hi, h_max

  /// Its first component; the next ones are fan_out apart.
  KOKKOS_INLINE_FUNCTION double* node_of(int level, int k) const {
    const int at = first[level] + k;
    return nodes_.data() + static_cast<std::size_t>(at / fan_out) * (node_rows * fan_out) + at % fan_out;
  }

  int counts_[max_levels] = {};
  Kokkos::View<double*, MemorySpace> nodes_;
};

namespace detail {

template <int D, class C>
KOKKOS_INLINE_FUNCTION void fit_sub_cell(const CellTree<D>& tree, const C& columns, int k) {
  const int begin = k * sub_cell_size, end = min(begin + sub_cell_size, tree.n);
  Bounds<D> b = Bounds<D>::empty();
  for (int d = 0; d < D; ++d) {
    const double* x = columns.template row<Position>(d);
    for (int i = begin; i < end; ++i) b.lo[d] = min(b.lo[d], x[i]), b.hi[d] = max(b.hi[d], x[i]);
  }
  const double* h = columns.template row<Support>();
  for (int i = begin; i < end; ++i) b.h_max = max(b.h_max, h[i]);
  tree.set_node(0, k, b);
}

template <int D>
struct FitLevel {
  CellTree<D> tree;
  int level;
  KOKKOS_INLINE_FUNCTION void operator()(int k) const {
    const int begin = k * fan_out, end = min(begin + fan_out, tree.count(level - 1));
    Bounds<D> b = tree.node(level - 1, begin);
    for (int child = begin + 1; child < end; ++child) b.include(tree.node(level - 1, child));
    tree.set_node(level, k, b);
  }
};

/// A cell with its sub-cells.
template <int D, class C, class Cells>
struct FitCells {
  CellTree<D> tree;
  C columns;
  Cells cells;
  KOKKOS_INLINE_FUNCTION void operator()(int k) const {
    const int cell = cells.cell(k), last = min((cell + 1) * fan_out, tree.count(0));
    for (int s = cell * fan_out; s < last; ++s) fit_sub_cell(tree, columns, s);
    FitLevel<D>{tree, 1}(cell);
  }
};

}  // namespace detail

/// Every cell, for code that takes some of them.
struct AllCells {
  template <int D>
  int cells(const CellTree<D>& tree) const {
    return tree.cells();
  }
  KOKKOS_INLINE_FUNCTION int cell(int k) const { return k; }
};

/// Recomputes the boxes and h_max of some cells from the columns, and those of all nodes above.
template <int D, class C, class Cells = AllCells>
void fit(const CellTree<D>& tree, const C& columns, const Cells& cells = {}) {
  if (tree.n == 0) return;
  Kokkos::parallel_for("fit cells", Kokkos::RangePolicy<ExecutionSpace>(0, cells.cells(tree)),
                       detail::FitCells<D, C, Cells>{tree, columns, cells});
  for (int level = 2; level < tree.levels; ++level)
    Kokkos::parallel_for("fit nodes", Kokkos::RangePolicy<ExecutionSpace>(0, tree.count(level)),
                         detail::FitLevel<D>{tree, level});
}

/// The box of all particles and their largest h; call after fit().
template <int D>
KOKKOS_INLINE_FUNCTION Bounds<D> root(const CellTree<D>& tree) {
  Bounds<D> b = Bounds<D>::empty();
  for (int k = 0; k < tree.count(tree.levels - 1); ++k) b.include(tree.node(tree.levels - 1, k));
  return b;
}

namespace detail {
template <int D>
struct CopyRoot {
  CellTree<D> tree;
  KOKKOS_INLINE_FUNCTION void operator()(int) const { tree.all() = root(tree); }
};
}  // namespace detail

/// root() brought to the host.
template <int D>
Bounds<D> bounds_of_all(const CellTree<D>& tree) {
  Kokkos::parallel_for("root box", Kokkos::RangePolicy<ExecutionSpace>(0, 1), detail::CopyRoot<D>{tree});
  Bounds<D> all;
  Kokkos::deep_copy(ExecutionSpace(), Kokkos::View<Bounds<D>, Kokkos::HostSpace>(&all), tree.all);
  ExecutionSpace().fence("root box");
  return all;
}

/// Calls `visit(sub_cell, shift)` for every sub-cell, in every periodic image, whose box comes nearer to `target` than
/// `reach(h_max)`, the larger of the target's reach and, where pairs are symmetric, that of the other side; `reach`
/// takes one h_max or a pack of them. Leaves out what is below a node for which `skip(level, k)` holds.
template <int D, class Reach, class Visit, class Skip>
KOKKOS_INLINE_FUNCTION void walk_image(const CellTree<D>& tree, const Bounds<D>& target, const double* shift,
                                       const Reach& reach, Visit&& visit, const Skip& skip) {
  unsigned hits[max_levels];  // of the 8 nodes from begin[] on: those still to be gone into
  int begin[max_levels];
  int level = tree.levels - 1;
  begin[level] = 0;
  hits[level] = tree.near(level, 0, target, shift, reach);
  while (level < tree.levels) {
    if (hits[level] == 0) {
      ++level;
      continue;
    }
    const int k = begin[level] + lowest_bit(hits[level]);
    hits[level] &= hits[level] - 1;
    if (skip(level, k)) continue;
    if (level == 0) {
      visit(k, shift);
    } else {
      --level;
      begin[level] = k * fan_out;
      hits[level] = tree.near(level, begin[level], target, shift, reach);
    }
  }
}

/// Range of image numbers along axis d that can bring the particles within `distance` of the target.
template <int D>
KOKKOS_INLINE_FUNCTION void image_range(const CellTree<D>& tree, const Bounds<D>& all, const Bounds<D>& target, int d,
                                        double distance, int& from, int& to) {
  const double period = tree.domain.period[d];
  from = to = 0;
  if (period == 0) return;
  from = static_cast<int>(Kokkos::ceil((target.lo[d] - distance - all.hi[d]) / period));
  to = static_cast<int>(Kokkos::floor((target.hi[d] + distance - all.lo[d]) / period));
}

struct SkipNothing {
  KOKKOS_INLINE_FUNCTION bool operator()(int, int) const { return false; }
};

/// walk_image over every periodic image that can matter, also for supports wider than the box.
template <int D, class Reach, class Visit, class Skip = SkipNothing>
KOKKOS_INLINE_FUNCTION void walk(const CellTree<D>& tree, const Bounds<D>& all, const Bounds<D>& target,
                                 const Reach& reach, Visit&& visit, const Skip& skip = {}) {
  int from[3] = {0, 0, 0}, to[3] = {0, 0, 0};
  for (int d = 0; d < D; ++d) image_range(tree, all, target, d, reach(all.h_max), from[d], to[d]);
  for (int a = from[0]; a <= to[0]; ++a)
    for (int b = from[1]; b <= to[1]; ++b)
      for (int c = from[2]; c <= to[2]; ++c) {
        const int image[3] = {a, b, c};
        double shift[D];
        for (int d = 0; d < D; ++d) shift[d] = image[d] * tree.domain.period[d];
        walk_image(tree, target, shift, reach, visit, skip);
      }
}

}  // namespace sphk
