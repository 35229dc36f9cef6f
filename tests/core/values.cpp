// SPDX-License-Identifier: BSD-3-Clause

// Type lists, sets of field values and columns.
#include "kernels/core/values.hpp"

#include <gtest/gtest.h>

#include "kernels/core/columns.hpp"

namespace sphk::test {
namespace {

using Fields = List<Mass, Velocity, MaxSignalVelocity>;

static_assert(
    std::is_same_v<Union<List<Mass, Velocity>, List<Velocity, Density>, List<>>, List<Mass, Velocity, Density>>);
static_assert(contains<Mass, Fields> && !contains<Density, Fields>);
static_assert(is_subset<List<Velocity>, Fields> && !is_subset<List<Velocity, Density>, Fields>);
static_assert(component_count<3, Fields> == 5 && component_count<1, Fields> == 3);
static_assert(component_offset<3, Mass, Fields> == 0 && component_offset<3, MaxSignalVelocity, Fields> == 4);
static_assert(components<VelocityCurl, 2> == 1 && components<VelocityCurl, 3> == 3);

TEST(Values, AccumulationAddsSumsAndTakesMaxima) {
  Values<double, 3, Fields> total;
  set_zero(total);
  using P = simd<float, native_lanes<float>>;
  Values<P, 3, Fields> packs;
  set_zero(packs);
  float lane[native_lanes<float>];
  float sum = 0;
  for (int k = 0; k < native_lanes<float>; ++k) sum += lane[k] = float(k + 1);
  packs.m = load<P>(lane);
  packs.v[2] = packs.m;
  packs.v_sig = packs.m;
  accumulate(total, packs);
  accumulate(total, packs);
  EXPECT_EQ(total.m, 2 * sum);
  EXPECT_EQ(total.v[0], 0);
  EXPECT_EQ(total.v[2], 2 * sum);
  EXPECT_EQ(total.v_sig, native_lanes<float>);
}

TEST(Columns, StoreAndLoadAreInverse) {
  const Columns<3, Fields> columns("columns", 20);
  Values<double, 3, Fields> values;
  values.m = 1, values.v = {{2, 3, 4}}, values.v_sig = 5;
  columns.store(7, values);
  const auto back = columns.load<Fields>(7);
  EXPECT_EQ(back.m, 1);
  EXPECT_EQ(back.v[1], 3);
  EXPECT_EQ(back.v_sig, 5);
  EXPECT_EQ(columns.at<Velocity>(7, 2), 4);
  EXPECT_EQ(columns.at<Velocity>(8, 2), 0);
}

TEST(Vec, DotAndCross) {
  const Vec<double, 3> a{{1, 2, 3}}, b{{-2, 0.5, 4}};
  EXPECT_EQ(dot(a, b), 11);
  const auto c = cross(a, b);  // (2*4 - 3*0.5, 3*-2 - 1*4, 1*0.5 - 2*-2)
  EXPECT_EQ(c[0], 6.5);
  EXPECT_EQ(c[1], -10);
  EXPECT_EQ(c[2], 4.5);
}

}  // namespace
}  // namespace sphk::test
