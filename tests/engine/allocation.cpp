// SPDX-License-Identifier: BSD-3-Clause

// Nothing allocates inside a step, and a run holds the bytes that it says it does: counted by Kokkos' own tool hooks.
#include <gtest/gtest.h>

#include <Kokkos_Core.hpp>

#include "src/schemes/registry.hpp"
#include "tests/compiled_schemes.hpp"
#include "tests/engine/brute_force.hpp"

namespace sphk::test {
namespace {

int allocations = 0;

void count_allocation(Kokkos_Profiling_SpaceHandle, const char*, const void*, std::uint64_t) {
  ++allocations;
}

TEST(Allocation, DoesNotHappenInsideAStep) {
  const auto run = make_simulation(shaken_lattice(3, {8, 8, 8}, 0.2, true, 1), {.scheme = "gadget2", .neighbours = 48});
  run->step(1e9);  // the backend's scratch grows once
  Kokkos::Tools::Experimental::set_allocate_data_callback(count_allocation);
  const Kokkos::View<double*> seen("seen by the hook", 1);
  ASSERT_EQ(allocations, 1) << "the hook works";
  for (int step = 0; step < 60; ++step) run->step(1e9);  // sorts and counts of neighbours among them
  Kokkos::Tools::Experimental::set_allocate_data_callback(nullptr);
  EXPECT_EQ(allocations, 1);
}

double held = 0;  ///< bytes of views

void add_bytes(Kokkos_Profiling_SpaceHandle, const char*, const void*, std::uint64_t bytes) {
  held += static_cast<double>(bytes);
}
void take_bytes(Kokkos_Profiling_SpaceHandle, const char*, const void*, std::uint64_t bytes) {
  held -= static_cast<double>(bytes);
}

/// Views of a run with 27000 particles; headers of views and the ends of rows are some hundred bytes each.
TEST(Allocation, IsWhatTheRunSaysThatItHolds) {
  const ParticleSet gas = shaken_lattice(3, {30, 30, 30}, 0.2, true, 1);
  for (const char* steps : {global_steps, own_steps})
    for (const char* scheme : {"gadget2", "sphs", "osph"}) {
      if (!is_compiled(scheme)) continue;
      const SimulationSettings settings{.scheme = scheme, .steps = steps};
      make_simulation(gas, settings);  // tables and the backend's scratch are there once
      Kokkos::Tools::Experimental::set_allocate_data_callback(add_bytes);
      Kokkos::Tools::Experimental::set_deallocate_data_callback(take_bytes);
      held = 0;
      const auto run = make_simulation(gas, settings);
      const double bytes = held / static_cast<double>(gas.size());
      Kokkos::Tools::Experimental::set_allocate_data_callback(nullptr);
      Kokkos::Tools::Experimental::set_deallocate_data_callback(nullptr);
      EXPECT_NEAR(run->costs().bytes_per_particle, bytes, 0.02 * bytes) << scheme << ", " << steps;
    }
}

}  // namespace
}  // namespace sphk::test
