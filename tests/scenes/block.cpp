// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/block.hpp"

#include <gtest/gtest.h>

namespace sphk {
namespace {

TEST(Block, LatticePointsAreCellCentres) {
  const auto x = lattice_points({.dimension = 2, .counts = {2, 3, 1}, .lower = {-1, 5, 0}, .size = {4, 3, 1}});
  ASSERT_EQ(x.size(), 6u);
  EXPECT_EQ(x[0], (Array3{0, 5.5, 0}));
  EXPECT_EQ(x[5], (Array3{2, 7.5, 0}));
}

TEST(Block, CountsFollowTheDimension) {
  EXPECT_EQ(even_counts(1, 7), (GridCounts{7, 1, 1}));
  EXPECT_EQ(even_counts(2, 7), (GridCounts{7, 7, 1}));
  EXPECT_EQ(even_counts(3, 7), (GridCounts{7, 7, 7}));
  EXPECT_EQ((Block{.counts = {64, 32, 32}}).particles(), 65536u);
}

TEST(Block, WrapsIntoTheBox) {
  EXPECT_EQ(wrapped(2.5, 2), 0.5);
  EXPECT_EQ(wrapped(-0.5, 2), 1.5);
  EXPECT_EQ(wrapped(0, 2), 0);
  EXPECT_EQ(wrapped(-1e-20, 2), 0);  // -1e-20 + 2 rounds to 2, which lies outside
}

TEST(Block, AGlassIn1DIsTheLattice) {
  const Block block{.dimension = 1, .counts = {5, 1, 1}};
  EXPECT_EQ(arranged_points(block, "glass"), lattice_points(block));
}

}  // namespace
}  // namespace sphk
