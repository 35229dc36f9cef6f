// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <Kokkos_Core.hpp>

// Kokkos 4.5 and 4.6 crash here when GCC 12 compiles them: a default-constructed View, then assignment.
TEST(ViewAssignment, DefaultConstructedViewTakesAnother) {
  Kokkos::View<double*> a;
  const Kokkos::View<double*> b("b", 3);
  a = b;
  EXPECT_EQ(a.data(), b.data());
  EXPECT_EQ(a.extent(0), 3u);
  EXPECT_EQ(b.use_count(), 2);
}
