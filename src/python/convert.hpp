// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <optional>
#include <utility>

#include "src/python/live_run.hpp"
#include "src/python/runtime.hpp"

namespace sphk::python {

namespace nb = nanobind;

using Rows = nb::ndarray<const double, nb::ndim<2>, nb::c_contig, nb::device::cpu>;
using Numbers = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Ids = nb::ndarray<const std::uint64_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Array = nb::ndarray<nb::numpy, const double>;

/// What f gives, without the interpreter's lock, one call at a time.
template <class F>
decltype(auto) computing(F&& f) {
  const nb::gil_scoped_release others_go_on;
  const std::scoped_lock alone(engine_mutex());
  return std::forward<F>(f)();
}

/// A read-only array of that memory: (n, components), or (n,) where it has no rows.
Array array_of(const FieldArray& field);
/// The same of numbers that it takes over.
Array array_of(std::vector<double> numbers, std::size_t components = 1, bool rows = false);

/// Points with three coordinates, as rows of the first `dimension` of them.
Array points_of(const std::vector<Array3>& points, int dimension);

void bind_simulation(nb::module_& m);
void bind_arrangements(nb::module_& m);
void bind_maps(nb::module_& m);

}  // namespace sphk::python
