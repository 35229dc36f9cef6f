// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cells/tile.hpp"
#include "kernels/cells/tiled_cell.hpp"

namespace sphk {

/// Neighbours for one thread per particle: every particle walks the tree on its own. What a GPU runs, and an
/// independent check of the tiles on a host.
template <class T, int D, class FieldList, Reach mode, class C>
struct ThreadWalk {
  const C& columns;  ///< of targets
  Sources<C> sources;

  using Target = Values<T, D, Union<List<Position, InverseSupport>, FieldList>>;
  using Neighbour = Values<T, D, NeighbourFields<FieldList>>;

  KOKKOS_INLINE_FUNCTION Target target(int i) const {
    return load_relative<T, D>(typename Target::Fields{}, columns, Frame<D>::of(point(columns, i), columns, i), i);
  }
  /// Calls visit(values of j) for every particle of every sub-cell in reach of particle i.
  template <class Visit>
  KOKKOS_INLINE_FUNCTION void for_each(int i, double reach, Visit&& visit) const {
    const Bounds<D> here = point(columns, i);
    const Frame<D> frame = Frame<D>::of(here, columns, i);
    const auto reach_with = [=](const auto& h) {
      using P = std::remove_cvref_t<decltype(h)>;
      return mode == Reach::symmetric ? sphk::max(P(reach), h) : P(reach);
    };
    walk(sources.tree, root(sources.tree), here, reach_with, [&](int sub_cell, const double* shift) {
      const Frame<D> image = frame.shifted(shift);
      const int j0 = sub_cell * sub_cell_size, end = min(j0 + sub_cell_size, sources.tree.n);
      for (int j = j0; j < end; ++j) visit(neighbour(image, j));
    });
  }

 private:
  /// Particle i is at the origin of its frame.
  KOKKOS_INLINE_FUNCTION Neighbour neighbour(const Frame<D>& frame, int j) const {
    Neighbour values;
    load_fields(values, frame, j, typename Neighbour::Fields{});
    for (int d = 0; d < D; ++d)
      values.r_ij[d] = static_cast<T>(frame.x[d] - sources.columns.template at<Position>(j, d));
    values.r2 = dot(values.r_ij, values.r_ij);
    return values;
  }
  template <class... F>
  KOKKOS_INLINE_FUNCTION void load_fields(Neighbour& values, const Frame<D>& frame, int j, List<F...>) const {
    (load_field<F>(values, frame, j), ...);
  }
  template <class F>
  KOKKOS_INLINE_FUNCTION void load_field(Neighbour& values, const Frame<D>& frame, int j) const {
    if constexpr (!is_separation<F>) {
      T* c = component_array<F>(values);
      for (int k = 0; k < components<F, D>; ++k)
        c[k] = static_cast<T>(sources.columns.template at<F>(j, k) - frame.template reference<F>(k));
    }
  }
};

}  // namespace sphk
