// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/vector.h>

#include <algorithm>

#include "src/python/convert.hpp"
#include "src/report/projection.hpp"

namespace sphk::python {

namespace {

using Two = std::array<double, 2>;

/// Rows of pixels from the bottom up. `places`: (n, 3), zero along the axes that the gas does not fill.
Array map_of(const Rows& places, const Numbers& volume, const Numbers& value, const std::vector<double>& box_lower,
             const std::vector<double>& box_size, const std::vector<bool>& periodic, Two lower, Two size,
             std::array<int, 2> pixels, std::optional<double> z) {
  require_engine();
  const ProjectedGas gas{{places.data(), places.size()}, {volume.data(), volume.size()}, {value.data(), value.size()}};
  PictureFrame frame{.dimension = static_cast<int>(periodic.size()),
                     .box = {},
                     .lower = lower,
                     .size = size,
                     .pixels = pixels,
                     .z = z};
  std::ranges::copy(box_lower, frame.box.lower.begin());
  std::ranges::copy(box_size, frame.box.size.begin());
  std::ranges::copy(periodic, frame.box.periodic.begin());
  return array_of(computing([&] { return project(gas, frame).values; }), static_cast<std::size_t>(pixels[0]), true);
}

}  // namespace

void bind_maps(nb::module_& m) {
  m.def("map", &map_of, nb::arg("places"), nb::arg("volume"), nb::arg("value"), nb::arg("box_lower"),
        nb::arg("box_size"), nb::arg("periodic"), nb::arg("lower"), nb::arg("size"), nb::arg("pixels"),
        nb::arg("z").none(), "The field of gas on a grid of pixels.");
}

}  // namespace sphk::python
