// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/file_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "src/run/problem.hpp"
#include "src/schemes/registry.hpp"
#include "tests/cli/gas_file.hpp"
#include "tests/compiled_schemes.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

/// A line of 200 particles that fills its periodic box, at rest, with rho = P = 1.
ParticleSet line() {
  constexpr int n = 200;
  ParticleSet gas;
  gas.dimension = 1;
  gas.box.periodic[0] = true;
  for (int i = 0; i < n; ++i) gas.x.push_back({(i + 0.5) / n, 0, 0});
  gas.v.assign(n, {});
  gas.m.assign(n, 1.0 / n);
  gas.u.assign(n, 1.5);
  gas.h.assign(n, 2.5 / n);
  return gas;
}

/// The state at t = 0.2, with boundaries as asked.
Snapshot state(const std::string& file, const std::string& periodic) {
  const Problem problem =
      resolve_problem(file, overrides_of({{"scene.periodic", periodic}, {"sph.precision", "double"}}));
  const auto run = make_simulation(problem.scene->build(problem.settings), simulation_settings(problem.settings));
  while (run->time() < 0.2) run->step(0.2);
  return run->snapshot();
}

// Through a plane in the middle goes the momentum P t, as long as no rarefaction has come there, at t = 0.5 / c = 0.39.
// In an open box it stays with the right half, whose gas leaves through the face; in a periodic one the next image
// takes it back. Cubic splines measure the density of a line, and with it P, to some per cent.
TEST(FileScene, AnOpenBoxLetsGasOutWhereAPeriodicOneIsFull) {
  if (!is_compiled("sph")) GTEST_SKIP();
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "full.hdf5").string();
  write_gas_file(file, line());
  const auto right_half = [](const Snapshot& s) {
    double momentum = 0;
    for (std::size_t i = s.size() / 2; i < s.size(); ++i)
      momentum += s.field("Masses").values[i] * s.field("Velocities").values[3 * i];
    return momentum;
  };
  const Snapshot open = state(file, "no"), full = state(file, "file");
  EXPECT_NEAR(right_half(open), 0.2, 0.006);
  EXPECT_NEAR(right_half(full), 0, 1e-9);
  const auto& x = open.field("Coordinates").values;
  EXPECT_GT(std::ranges::max(x), 1.2);
  EXPECT_LT(std::ranges::min(x), -0.2);
  EXPECT_FALSE(open.box.periodic[0]);
  EXPECT_EQ(open.box.size, full.box.size);
}

}  // namespace
}  // namespace sphk
