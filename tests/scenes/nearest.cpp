// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/nearest.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/scenes/random.hpp"

namespace sphk {
namespace {

/// `count` particles at random in a periodic box, all in its lower part where `clumped`.
Snapshot random_gas(int dimension, int count, bool clumped) {
  Snapshot snapshot;
  snapshot.dimension = dimension;
  snapshot.box = {.lower = {-1, 2, 0}, .size = {3, 1, 0.5}};
  Field x{"Coordinates", "", {}, 3, {}};
  Uniform uniform(7);
  for (int i = 0; i < count; ++i) {
    snapshot.id.push_back(i + 1);
    for (int axis = 0; axis < 3; ++axis) {
      const double share = clumped ? uniform() / 8 : uniform();
      x.values.push_back(axis < dimension ? snapshot.box.lower[axis] + share * snapshot.box.size[axis] : 0);
    }
  }
  snapshot.fields = {x};
  return snapshot;
}

double by_trying_all(const Snapshot& snapshot, const Array3& x, std::size_t self) {
  const std::vector<double>& all = snapshot.fields[0].values;
  double best = INFINITY;
  for (std::size_t j = 0; j < snapshot.size(); ++j) {
    double r2 = 0;
    for (int axis = 0; axis < snapshot.dimension; ++axis) {
      const double size = snapshot.box.size[axis], d = std::fmod(std::abs(all[3 * j + axis] - x[axis]), size);
      r2 += std::pow(std::min(d, size - d), 2);
    }
    if (j != self) best = std::min(best, std::sqrt(r2));
  }
  return best;
}

TEST(NearestParticle, IsTheOneThatTryingAllFinds) {
  for (int D = 1; D <= 3; ++D)
    for (const bool clumped : {false, true})
      for (const int count : {1, 2, 200}) {
        const Snapshot gas = random_gas(D, count, clumped);
        const NearestParticle nearest(gas);
        Uniform uniform(3);
        for (int sample = 0; sample < 100; ++sample) {
          const Array3 x{4 * uniform() - 2, 3 * uniform(), uniform()};  // also outside the box
          EXPECT_NEAR(nearest.distance(x), by_trying_all(gas, x, NearestParticle::none), 1e-14) << D << ' ' << count;
        }
        for (std::size_t i = 0; i < gas.size(); ++i) {
          const auto at = gas.fields[0].values.begin() + 3 * static_cast<std::ptrdiff_t>(i);
          const Array3 x{at[0], at[1], at[2]};
          EXPECT_EQ(nearest.distance(x), 0);
          if (count == 1) continue;
          EXPECT_NEAR(nearest.distance(x, i), by_trying_all(gas, x, i), 1e-14) << D << ' ' << i;
        }
      }
}

}  // namespace
}  // namespace sphk
