// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/stl/array.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>

#include "src/python/convert.hpp"
#include "src/scenes/block.hpp"
#include "src/scenes/mass_profile.hpp"
#include "src/schemes/registry.hpp"

namespace sphk::python {

namespace {

Array arranged(const std::vector<int>& counts, const std::vector<double>& lower, const std::vector<double>& size,
               const std::string& arrangement, std::uint64_t seed) {
  Block block{.dimension = static_cast<int>(counts.size())};
  std::ranges::copy(counts, block.counts.begin());
  std::ranges::copy(lower, block.lower.begin());
  std::ranges::copy(size, block.size.begin());
  require_engine();
  return points_of(computing([&] { return arranged_points(block, arrangement, seed); }), block.dimension);
}

/// Of densities in the midpoints of cells.
MassProfile profile_of(const Numbers& rho, double lower, double size) {
  const auto cells = static_cast<int>(rho.size());
  int cell = 0;
  return MassProfile([&](double) { return rho(static_cast<std::size_t>(cell++)); }, lower, size, cells);
}

Array places(const MassProfile& profile, const Numbers& shares) {
  std::vector<double> found(shares.size());
  for (std::size_t i = 0; i < found.size(); ++i) found[i] = profile.place(shares(i));
  return array_of(std::move(found));
}

}  // namespace

void bind_arrangements(nb::module_& m) {
  m.def("arranged", &arranged, nb::arg("counts"), nb::arg("lower"), nb::arg("size"), nb::arg("arrangement"),
        nb::arg("seed") = 1, "Points of a box, counts[k] along axis k: cubic, glass or random.");
  nb::class_<MassProfile>(m, "MassProfile", "The mass below a place, of densities in equal cells of an interval.")
      .def(
          "__init__",
          [](MassProfile* self, const Numbers& rho, double lower, double size) {
            new (self) MassProfile(profile_of(rho, lower, size));
          },
          nb::arg("rho"), nb::arg("lower"), nb::arg("size"))
      .def_prop_ro("mass", &MassProfile::mass)
      .def("places", &places, nb::arg("shares"), "Where these shares of the mass, 0 to 1, lie below: (n,).");
  m.def("scheme_names", &scheme_names, "The schemes that a simulation may have.");
  m.def("kernel_names", &kernel_names, "The smoothing kernels that a simulation may have.");
}

}  // namespace sphk::python
