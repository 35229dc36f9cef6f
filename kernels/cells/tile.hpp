// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>

#include "kernels/cells/cell_tree.hpp"

namespace sphk {

/// Origin of the relative coordinates and velocities of a cell's pair arithmetic: floats then resolve differences, not
/// places, wherever the cell is and however fast it moves.
template <int D>
struct Frame {
  double x[D];
  double v[D];

  template <class F>
  KOKKOS_FORCEINLINE_FUNCTION double reference(int component) const {
    if constexpr (F::facts.relative == Relative::place)
      return x[component];
    else if constexpr (F::facts.relative == Relative::motion)
      return v[component];
    else
      return 0;
  }
  /// The frame of the particles around `bounds`, moving with the middle velocity of three of them, so that one that is
  /// much faster than all others does not carry the frame away.
  template <class C>
  KOKKOS_INLINE_FUNCTION static Frame of(const Bounds<D>& bounds, const C& columns, int first, int second, int third) {
    Frame frame;
    for (int d = 0; d < D; ++d) {
      frame.x[d] = 0.5 * (bounds.lo[d] + bounds.hi[d]);
      const double a = columns.template at<Velocity>(first, d), b = columns.template at<Velocity>(second, d),
                   c = columns.template at<Velocity>(third, d);
      frame.v[d] = max(min(a, b), min(max(a, b), c));
    }
    return frame;
  }
  /// The same, moving with particle i.
  template <class C>
  KOKKOS_INLINE_FUNCTION static Frame of(const Bounds<D>& bounds, const C& columns, int i) {
    return of(bounds, columns, i, i, i);
  }
  KOKKOS_INLINE_FUNCTION Frame shifted(const double* shift) const {
    Frame frame = *this;
    for (int d = 0; d < D; ++d) frame.x[d] -= shift[d];
    return frame;
  }
};

/// Which particles of a cell are computed: a bit each, the first the lowest.
using TargetMask = std::uint64_t;

/// Calls f(i) for the particles of a mask, whose first bit is that of particle `begin`.
template <class F>
KOKKOS_FORCEINLINE_FUNCTION void for_each_of(TargetMask mask, int begin, F&& f) {
  for (; mask != 0; mask &= mask - 1) f(begin + Kokkos::countr_zero(mask));
}

template <int D>
KOKKOS_INLINE_FUNCTION TargetMask all_targets(const CellTree<D>& tree, int cell) {
  const int n = min(cell_size, tree.n - cell * cell_size);
  return n == cell_size ? ~TargetMask(0) : (TargetMask(1) << n) - 1;
}

/// Where neighbours are looked for: among particles of which the targets may be a part.
template <class C>
struct Sources {
  const CellTree<C::dimension>& tree;
  const C& columns;
};

/// The box of one particle.
template <class C, int D = C::dimension>
KOKKOS_INLINE_FUNCTION Bounds<D> point(const C& columns, int i) {
  Bounds<D> b;
  for (int d = 0; d < D; ++d) b.lo[d] = b.hi[d] = columns.template at<Position>(i, d);
  b.h_max = columns.template at<Support>(i);
  return b;
}

/// Particle i as the pair arithmetic sees it: T, relative to the frame, in every lane of P.
template <class P, int D, class... F, class C>
KOKKOS_FORCEINLINE_FUNCTION Values<P, D, List<F...>> load_relative(List<F...>, const C& columns, const Frame<D>& frame,
                                                                   int i) {
  using T = lane_t<P>;
  Values<P, D, List<F...>> values;
  const auto fill = [&]<class G>() {
    P* c = component_array<G>(values);
    for (int k = 0; k < components<G, D>; ++k)
      c[k] = P(static_cast<T>(columns.template at<G>(i, k) - frame.template reference<G>(k)));
  };
  (fill.template operator()<F>(), ...);
  return values;
}

template <class F>
inline constexpr bool is_separation = std::is_same_v<F, Separation> || std::is_same_v<F, Distance2>;

namespace detail {
template <class F>
using NotPosition = std::bool_constant<!std::is_same_v<F, Position>>;
}  // namespace detail

/// What a particle's neighbour has where a particle has the fields of the list: the separation in place of the
/// position.
template <class FieldList>
using NeighbourFields = Union<List<Separation, Distance2>, Filter<FieldList, detail::NotPosition>>;

/// Candidate neighbours side by side in scratch memory: a row of T per component of the fields, `count` entries each.
template <class T, int D, class FieldList>
struct Tile {
  using Fields = FieldList;
  static constexpr int rows = component_count<D, FieldList>;
  static constexpr int capacity = 3072;
  static constexpr int stride = capacity + 64 / static_cast<int>(sizeof(T));  ///< an odd number of cache lines
  static constexpr int entries = rows * stride;

  T* data;
  int count = 0;

  /// Where a component's row starts.
  template <class F>
  static constexpr int offset(int component = 0) {
    return (component_offset<D, F, FieldList> + component) * stride;
  }
  template <class F>
  T* row(int component = 0) const {
    return data + offset<F>(component);
  }
  template <class P, class F>
  KOKKOS_FORCEINLINE_FUNCTION P load(int k, int component = 0) const {
    return sphk::load<P>(data + offset<F>(component) + k);
  }
  /// The entries from k on as neighbours of a particle at x.
  template <class P>
  KOKKOS_FORCEINLINE_FUNCTION Values<P, D, NeighbourFields<FieldList>> neighbours(int k, const Vec<P, D>& x) const {
    Values<P, D, NeighbourFields<FieldList>> j;
    for (int d = 0; d < D; ++d) j.r_ij[d] = x[d] - load<P, Position>(k, d);
    j.r2 = dot(j.r_ij, j.r_ij);
    for_each_type(NeighbourFields<FieldList>{}, RowLoader<P>{*this, j, k});
    return j;
  }

  /// Fills up to whole packs with copies of the last entry, moved to x along the first axis.
  template <class P>
  void pad(T x) {
    if (count % lanes<P> == 0) return;
    for (int row = 0; row < rows; ++row) {
      T* const end = data + row * stride + count;
      store(end, P(end[-1]));
    }
    store(row<Position>() + count, P(x));
    count += lanes<P> - count % lanes<P>;
  }

 private:
  template <class P>
  struct RowLoader {
    const Tile& tile;
    Values<P, D, NeighbourFields<FieldList>>& j;
    int k;
    template <class F>
    KOKKOS_FORCEINLINE_FUNCTION void operator()() const {
      if constexpr (!is_separation<F>) {
        P* c = component_array<F>(j);
        for (int a = 0; a < components<F, D>; ++a) c[a] = tile.template load<P, F>(k, a);
      }
    }
  };
};

}  // namespace sphk
