// Nothing allocates inside a step: counted by Kokkos' own tool hooks.
#include <gtest/gtest.h>

#include <Kokkos_Core.hpp>

#include "src/schemes/registry.hpp"
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

}  // namespace
}  // namespace sphk::test
