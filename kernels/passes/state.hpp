#pragma once

#include "kernels/cells/cell_tree.hpp"
#include "kernels/cells/pair.hpp"
#include "kernels/cells/sorter.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

/// Pair loops run over tiles on the host and with one thread per particle on a GPU.
inline constexpr bool tiles_pay =
    Kokkos::SpaceAccessibility<Kokkos::HostSpace, MemorySpace>::accessible;

/// What every pass sees of a run: the particles of scheme S, sorted, with their cells. Copied into functors by value.
template <class S>
struct State {
  static constexpr int dimension = S::dimension;
  using Columns = sphk::Columns<dimension, typename S::Fields>;
  using PairNumber = typename S::PairNumber;

  int n = 0;
  Columns columns;
  Ids ids;
  CellTree<dimension> tree;
  Smoothing<typename S::Kernel, dimension> smoothing;
  Parameters parameters;

  template <class F>
  KOKKOS_FORCEINLINE_FUNCTION double& at(int i, int component = 0) const {
    return columns.template at<F>(i, component);
  }
};

}  // namespace sphk
