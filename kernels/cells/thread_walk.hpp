#pragma once

#include "kernels/cells/tile.hpp"
#include "kernels/cells/tiled_cell.hpp"

namespace sphk {

/// Neighbours for one thread per particle: every particle walks the tree on its own. What a GPU runs, and an
/// independent check of the tiles on a host.
template <class T, int D, class FieldList, Reach mode, class C>
struct ThreadWalk {
  const CellTree<D>& tree;
  const C& columns;

  KOKKOS_INLINE_FUNCTION Bounds<D> point(int i) const {
    Bounds<D> b;
    for (int d = 0; d < D; ++d) b.lo[d] = b.hi[d] = columns.template at<Position>(i, d);
    b.h_max = columns.template at<Support>(i);
    return b;
  }
  KOKKOS_INLINE_FUNCTION Values<T, D, Union<FieldList, List<InverseSupport>>> target(int i) const {
    return load_relative<T, D>(Union<FieldList, List<InverseSupport>>{}, columns, Frame<D>::of(point(i), columns, i),
                               i);
  }
  /// Calls visit(values of j) for every particle of every sub-cell in reach of particle i.
  template <class Visit>
  KOKKOS_INLINE_FUNCTION void for_each(int i, double reach, Visit&& visit) const {
    const Bounds<D> here = point(i);
    const Frame<D> frame = Frame<D>::of(here, columns, i);
    const auto reach_with = [=](double h) { return mode == Reach::symmetric ? max(reach, h) : reach; };
    walk(tree, root(tree), here, reach_with, [&](int sub_cell, const double* shift) {
      const Frame<D> image = frame.shifted(shift);
      const int j0 = sub_cell * sub_cell_size, end = min(j0 + sub_cell_size, tree.n);
      for (int j = j0; j < end; ++j) visit(load_relative<T, D>(FieldList{}, columns, image, j));
    });
  }
};

}  // namespace sphk
