#pragma once

#include "kernels/cells/cell_tree.hpp"
#include "kernels/cells/sorter.hpp"
#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

/// Pair loops run over tiles on the host and with one thread per particle on a GPU.
inline constexpr bool tiles_pay = Kokkos::SpaceAccessibility<Kokkos::HostSpace, MemorySpace>::accessible;

/// What the particles of a scheme are: dimension, fields, thermal variable. Schemes that differ only in smoothing
/// kernel or pair arithmetic share a layout, and all code that knows no more of them.
template <int D, class FieldList, class Form>
struct Layout {
  static constexpr int dimension = D;
  using Fields = FieldList;
  using ThermalForm = Form;
};

/// The particles of a run, sorted, with their cells. Copied into functors by value.
template <class L>
struct Particles {
  using Columns = sphk::Columns<L::dimension, typename L::Fields>;

  int n = 0;
  Columns columns;
  Ids ids;
  CellTree<L::dimension> tree;
  Parameters parameters;

  template <class F>
  KOKKOS_FORCEINLINE_FUNCTION double& at(int i, int component = 0) const {
    return columns.template at<F>(i, component);
  }
};

/// Particles and the smoothing kernel that pair loops need.
template <class S>
struct State : Particles<typename S::Layout> {
  Smoothing<typename S::Kernel, S::dimension> smoothing;
};

}  // namespace sphk
