// SPDX-License-Identifier: BSD-3-Clause

// A run that is saved and restored goes on bit by bit, under every scheme.
#include <gtest/gtest.h>

#include "src/engine/errors.hpp"
#include "src/schemes/registry.hpp"
#include "tests/engine/brute_force.hpp"

namespace sphk::test {
namespace {

/// Steps to t_end or `steps` of them.
void go(Simulation& run, int steps, double t_end) {
  for (int k = 0; k < steps && run.time() < t_end; ++k) run.step(t_end);
}

/// The particles of a snapshot, as a checkpoint's reader gives them.
ParticleSet particles_of(const Snapshot& snapshot) {
  ParticleSet gas;
  gas.dimension = snapshot.dimension;
  gas.box = snapshot.box;
  gas.time = snapshot.time;
  gas.id = snapshot.id;
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    const auto vector = [&](const char* name) {
      const auto& v = snapshot.field(name).values;
      return Array3{v[3 * i], v[3 * i + 1], v[3 * i + 2]};
    };
    gas.x.push_back(vector("Coordinates"));
    gas.v.push_back(vector("Velocities"));
    gas.m.push_back(snapshot.field("Masses").values[i]);
    gas.u.push_back(snapshot.field("InternalEnergies").values[i]);
    gas.h.push_back(snapshot.field("SmoothingLength").values[i]);
  }
  return gas;
}

void expect_same(const Simulation& a, const Simulation& b, const std::string& what) {
  const Snapshot x = a.snapshot(), y = b.snapshot();
  ASSERT_EQ(x.fields.size(), y.fields.size()) << what;
  EXPECT_EQ(x.time, y.time) << what;
  EXPECT_EQ(x.id, y.id) << what;
  for (std::size_t k = 0; k < x.fields.size(); ++k)
    EXPECT_EQ(x.fields[k].values, y.fields[k].values) << what << ", " << x.fields[k].name;
  EXPECT_EQ(a.last_step().dt, b.last_step().dt) << what;
  EXPECT_EQ(a.costs().updates, b.costs().updates) << what;
}

TEST(SavedState, GoesOnBitByBitUnderEveryScheme) {
  for (const std::string& scheme : scheme_names())
    for (const int D : {1, 2, 3})
      for (const bool individual : {false, true}) {
        const std::string what = scheme + " in " + std::to_string(D) + "D" + (individual ? ", individual steps" : "");
        if (D == 3 && !individual) continue;  // the other path is the same in any dimension
        const Array3 sides[] = {{40, 1, 1}, {12, 12, 1}, {6, 6, 6}};
        ParticleSet gas = shaken_lattice(D, sides[D - 1], 0.3, D != 2, 5);
        for (std::size_t i = 0; i < gas.size(); ++i) {
          gas.tag.push_back(static_cast<int>(i % 3));
          gas.u[i] *= i % 7 == 0 ? 30 : 1;  // steps of unlike lengths
          if (i % 5 == 0) gas.m[i] *= 1.5;  // and masses to exchange
        }
        SimulationSettings settings;
        settings.scheme = scheme;
        settings.kernel = "wc6";
        settings.neighbours = D == 1 ? 8 : D == 2 ? 30 : 60;
        settings.steps = individual ? own_steps : global_steps;
        const auto whole = make_simulation(gas, settings);
        go(*whole, 11, 0.05);  // in the midst of a block of individual steps, and after a sort
        const SavedState saved = whole->save();
        const auto resumed = make_simulation(particles_of(whole->snapshot()), settings);
        resumed->restore(saved);
        expect_same(*whole, *resumed, what + ", restored");
        for (const double t_end : {0.03, 0.06, 1.0}) {
          go(*whole, 12, t_end);
          go(*resumed, 12, t_end);
        }
        EXPECT_GT(whole->last_step().step, 15) << what;
        expect_same(*whole, *resumed, what);
      }
}

TEST(SavedState, OfAnotherRunIsRefused) {
  SimulationSettings settings;
  settings.neighbours = 48;
  const auto small = make_simulation(shaken_lattice(3, {8, 8, 8}, 0.1, true, 1), settings);
  const auto large = make_simulation(shaken_lattice(3, {8, 8, 9}, 0.1, true, 1), settings);
  EXPECT_THROW(large->restore(small->save()), InputError);
  SavedState incomplete = small->save();
  incomplete.erase("time");
  EXPECT_THROW(small->restore(incomplete), InputError);
}

}  // namespace
}  // namespace sphk::test
