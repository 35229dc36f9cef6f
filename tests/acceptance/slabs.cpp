// SPDX-License-Identifier: BSD-3-Clause

// Thin periodic slabs against the same gas laid out side by side, in which every neighbour counts once.
#include <gtest/gtest.h>

#include <cmath>

#include "src/scenes/block.hpp"
#include "src/scenes/random.hpp"
#include "src/schemes/registry.hpp"

namespace sphk {
namespace {

constexpr double spacing = 1.0 / 16;  // it and whatever is added to it are exact, so that copies are exact too

double exact_in_sums(double x) {
  return std::round(x * 0x1p40) * 0x1p-40;
}

/// Periodic gas of so many particles along each axis, with uneven places, masses, velocities and energies.
ParticleSet uneven_gas(const GridCounts& counts) {
  Uniform uniform(1);
  const auto shift = [&] { return 2 * uniform() - 1; };
  Block block{.dimension = 3, .counts = counts};
  ParticleSet gas;
  gas.box.periodic = {true, true, true};
  for (int axis = 0; axis < 3; ++axis) gas.box.size[axis] = block.size[axis] = counts[axis] * spacing;
  gas.x = lattice_points(block);
  for (Array3& x : gas.x) {
    for (int axis = 0; axis < 3; ++axis)
      x[axis] = wrapped(exact_in_sums(x[axis] + 0.2 * spacing * shift()), gas.box.size[axis]);
    gas.v.push_back({shift(), shift(), shift()});
    gas.m.push_back((1 + 0.1 * shift()) * spacing * spacing * spacing);
    gas.u.push_back(1 + 0.2 * shift());
  }
  return gas;
}

/// Copies of the gas side by side; particle i of each is i modulo the number of particles.
ParticleSet laid_out(const ParticleSet& gas, const GridCounts& copies) {
  ParticleSet all;
  all.box = gas.box;
  for (int axis = 0; axis < 3; ++axis) all.box.size[axis] *= copies[axis];
  for (int a = 0; a < copies[0]; ++a)
    for (int b = 0; b < copies[1]; ++b)
      for (int c = 0; c < copies[2]; ++c)
        for (std::size_t i = 0; i < gas.size(); ++i) {
          const Array3& x = gas.x[i];
          all.x.push_back({x[0] + a * gas.box.size[0], x[1] + b * gas.box.size[1], x[2] + c * gas.box.size[2]});
          all.v.push_back(gas.v[i]);
          all.m.push_back(gas.m[i]);
          all.u.push_back(gas.u[i]);
        }
  return all;
}

std::vector<Field> rates_of(const ParticleSet& gas, const std::string& scheme) {
  return make_simulation(gas, {.scheme = scheme, .kernel = "hoct4", .precision = "double", .neighbours = 442})
      ->rates(false);
}

struct Slab {
  const char* name;
  const char* scheme;
  GridCounts counts, copies;
};

void PrintTo(const Slab& slab, std::ostream* stream) {
  *stream << slab.name << " " << slab.scheme;
}

class Slabs : public testing::TestWithParam<Slab> {};

// Each rate is a sum over the same neighbours, in another order: 1e-12 of the largest is some thousand roundings.
TEST_P(Slabs, HaveTheRatesOfTheGasLaidOutSideBySide) {
  const Slab& slab = GetParam();
  const ParticleSet gas = uneven_gas(slab.counts);
  const std::vector<Field> thin = rates_of(gas, slab.scheme), wide = rates_of(laid_out(gas, slab.copies), slab.scheme);
  ASSERT_EQ(thin.size(), wide.size());
  for (std::size_t f = 0; f < thin.size(); ++f) {
    const std::vector<double>&one = thin[f].values, &all = wide[f].values;
    ASSERT_EQ(all.size(), one.size() * slab.copies[0] * slab.copies[1] * slab.copies[2]) << thin[f].name;
    double scale = 0, off = 0;
    for (const double value : one) scale = std::max(scale, std::abs(value));
    for (std::size_t k = 0; k < all.size(); ++k) {
      ASSERT_TRUE(std::isfinite(all[k])) << thin[f].name;
      off = std::max(off, std::abs(all[k] - one[k % one.size()]));
    }
    EXPECT_LE(off, 1e-12 * scale) << thin[f].name;
  }
}

// Supports of 442 neighbours are 9.5 spacings wide.
INSTANTIATE_TEST_SUITE_P(OfLayers, Slabs,
                         testing::Values(Slab{"8 layers", "gadget2", {12, 12, 8}, {1, 1, 2}},
                                         Slab{"4 layers", "gadget2", {12, 12, 4}, {1, 1, 3}},
                                         Slab{"2 layers", "gadget2", {12, 12, 2}, {1, 1, 5}},
                                         Slab{"1 layer", "gadget2", {12, 12, 1}, {1, 1, 10}},
                                         Slab{"8 layers", "sphs", {12, 12, 8}, {1, 1, 2}},
                                         Slab{"4 layers", "sphs", {12, 12, 4}, {1, 1, 3}},
                                         Slab{"2 layers", "sphs", {12, 12, 2}, {1, 1, 5}},
                                         Slab{"1 layer", "sphs", {12, 12, 1}, {1, 1, 10}}));
INSTANTIATE_TEST_SUITE_P(OfLines, Slabs,
                         testing::Values(Slab{"1000:1:1", "gadget2", {1000, 1, 1}, {1, 10, 10}},
                                         Slab{"1000:1:1", "sphs", {1000, 1, 1}, {1, 10, 10}}));

}  // namespace
}  // namespace sphk
