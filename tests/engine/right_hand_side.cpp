// SPDX-License-Identifier: BSD-3-Clause

// The engine's rates against explicit sums over all pairs and images. Both are in double: they differ by the order of
// sums (1e-13 of the largest term) and by the search for h, which ends within 1e-14 (a move of 1e-7, carried over to
// second order); tolerances leave a decade for cancellation in the sums.
#include <gtest/gtest.h>

#include <cmath>

#include "src/schemes/registry.hpp"
#include "tests/engine/brute_force.hpp"
#include "tests/engine/compare_fields.hpp"

namespace sphk::test {
namespace {

struct Case {
  std::string name, scheme, kernel;
  int dimension;
  Array3 counts;
  double neighbours;
  bool periodic;
};

class RightHandSide : public testing::TestWithParam<Case> {
 protected:
  SimulationSettings settings() const {
    SimulationSettings s;
    s.scheme = GetParam().scheme;
    s.kernel = GetParam().kernel;
    s.neighbours = GetParam().neighbours;
    s.precision = "double";
    return s;
  }
  ParticleSet particles() const {
    return shaken_lattice(GetParam().dimension, GetParam().counts, 0.3, GetParam().periodic, 7);
  }
};

TEST_P(RightHandSide, EqualsTheExplicitSums) {
  const ParticleSet gas = particles();
  const SimulationSettings s = settings();
  const BruteForce wanted(gas, s);
  const auto got = make_simulation(gas, s)->rates(false);
  const double table = GetParam().kernel == "cs" ? 1 : 1e4;  // kernels off the curated list run through the table
  expect_near(named(got, "SmoothingLength"), wanted.h, 1e-12 * table, "h");
  expect_near(named(got, "Density"), wanted.rho, 1e-12 * table, "rho");
  expect_near(named(got, "VelocityDivergence"), wanted.div_v, 1e-11 * table, "div v");
  expect_near(named(got, "VelocityCurl"), flat(wanted.curl_v), 1e-11 * table, "curl v");
  expect_near(named(got, "Acceleration"), flat(wanted.a), 1e-11 * table, "a");
  expect_near(named(got, "EntropyRate"), wanted.entropy_rate, 1e-11 * table, "dA/dt");
  expect_near(named(got, "NeighbourCount"), wanted.count, 0, "count");
}

/// Float pairs: 6e-8 per operation on terms of either sign; the sums hold some hundred of them.
TEST_P(RightHandSide, OfMixedPrecisionStaysWithinFloatRounding) {
  const ParticleSet gas = particles();
  SimulationSettings s = settings();
  const BruteForce wanted(gas, s);
  s.precision = "mixed";
  const auto simulation = make_simulation(gas, s);
  const Snapshot snapshot = simulation->snapshot();
  expect_near(snapshot.field("SmoothingLength").values, wanted.h, 1e-6, "h");
  expect_near(snapshot.field("Densities").values, wanted.rho, 2e-6, "rho");
  expect_near(snapshot.field("VelocityDivergence").values, wanted.div_v, 5e-6, "div v");
}

INSTANTIATE_TEST_SUITE_P(
    Cases, RightHandSide,
    testing::Values(Case{"sph_3d", "sph", "cs", 3, {8, 8, 8}, 48, true},
                    Case{"sph_3d_open", "sph", "cs", 3, {7, 8, 9}, 48, false},
                    Case{"tsph_3d", "tsph", "ct", 3, {8, 8, 8}, 64, true},
                    Case{"gadget2_3d", "gadget2", "cs", 3, {9, 8, 7}, 42, true},
                    Case{"gadget2_3d_slab_of_two_layers", "gadget2", "cs", 3, {9, 9, 2}, 128, true},
                    Case{"gadget2_3d_slab_of_one_layer", "gadget2", "cs", 3, {9, 9, 1}, 442, true},
                    Case{"sph_3d_rod_wider_than_the_box", "sph", "hoct4", 3, {40, 1, 2}, 128, true},
                    Case{"sph_2d", "sph", "cs", 2, {12, 10, 1}, 32, true},
                    Case{"gadget2_2d_open", "gadget2", "cs", 2, {12, 10, 1}, 24, false},
                    Case{"tsph_2d_table", "tsph", "wc2", 2, {12, 10, 1}, 32, true},
                    Case{"gadget2_1d_table", "gadget2", "m6", 1, {40, 1, 1}, 10, true},
                    Case{"sph_1d_hydra", "sph", "hydra", 1, {40, 1, 1}, 8, false}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace sphk::test
