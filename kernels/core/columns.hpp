// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>
#include <string>

#include "kernels/core/values.hpp"

namespace sphk {

using ExecutionSpace = Kokkos::DefaultExecutionSpace;
using MemorySpace = ExecutionSpace::memory_space;

/// Particles of a sub-cell, the unit in which columns are padded.
inline constexpr int sub_cell_size = 8;

/// One number type of view for all columns keeps the compile time of copies down.
using ColumnNumbers = Kokkos::View<double*, MemorySpace>;
using HostNumbers = Kokkos::View<double*, Kokkos::HostSpace>;

/// Particle state as structure of arrays: one row of doubles per component, padded so that any sub-cell can be read
/// whole.
template <int D, class FieldList>
struct Columns {
  using Fields = FieldList;
  static constexpr int dimension = D;
  static constexpr int size = component_count<D, Fields>;
  ColumnNumbers data;  ///< component c of particle i is data(c * stride + i)
  int stride = 0;

  Columns() = default;
  Columns(const ColumnNumbers& rows, int row_length) : data(rows), stride(row_length) {}
  Columns(const std::string& label, int n)
      : data(label, static_cast<std::size_t>(size) * padded(n)), stride(padded(n)) {}

  /// An odd number of cache lines, so that rows do not share cache sets.
  static int padded(int n) { return ((n / sub_cell_size + 1) | 1) * sub_cell_size; }

  template <class F>
  KOKKOS_FORCEINLINE_FUNCTION double* row(int component = 0) const {
    static_assert(contains<F, Fields>, "this scheme has no such field: add it to what a pass or term reads or adds");
    return data.data() + static_cast<std::size_t>(component_offset<D, F, Fields> + component) * stride;
  }
  template <class F>
  KOKKOS_FORCEINLINE_FUNCTION double& at(int i, int component = 0) const {
    return row<F>(component)[i];
  }

  /// The values of particle i, for the fields of the list.
  template <class Wanted>
  KOKKOS_FORCEINLINE_FUNCTION Values<double, D, Wanted> load(int i) const {
    Values<double, D, Wanted> values;
    for_each_type(Wanted{}, Loader<Wanted>{*this, values, i});
    return values;
  }
  template <class Given>
  KOKKOS_FORCEINLINE_FUNCTION void store(int i, const Values<double, D, Given>& values) const {
    for_each_type(Given{}, Storer<Given>{*this, values, i});
  }

 private:
  template <class Wanted>
  struct Loader {
    const Columns& columns;
    Values<double, D, Wanted>& values;
    int i;
    template <class F>
    KOKKOS_FORCEINLINE_FUNCTION void operator()() const {
      double* c = component_array<F>(values);
      for (int k = 0; k < components<F, D>; ++k) c[k] = columns.template at<F>(i, k);
    }
  };
  template <class Given>
  struct Storer {
    const Columns& columns;
    const Values<double, D, Given>& values;
    int i;
    template <class F>
    KOKKOS_FORCEINLINE_FUNCTION void operator()() const {
      const double* c = component_array<F>(values);
      for (int k = 0; k < components<F, D>; ++k) columns.template at<F>(i, k) = c[k];
    }
  };
};

}  // namespace sphk
