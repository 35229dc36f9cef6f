// SPDX-License-Identifier: BSD-3-Clause

// Sorting and cells against what they promise, checked particle by particle.
#include "kernels/cells/cell_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include "kernels/cells/sorter.hpp"

namespace sphk::test {
namespace {

using Fields = List<Position, Support>;

template <int D>
struct Cloud {
  Columns<D, Fields> columns;
  Ids ids;
  CellTree<D> tree;

  Cloud(int n, const Domain<D>& domain, unsigned seed) : columns("cloud", n), ids("ids", n), tree(n, domain) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < n; ++i) {
      // Clustered: density contrasts of a million.
      const double scale = std::pow(10.0, -2 * unit(engine));
      for (int d = 0; d < D; ++d) columns.template at<Position>(i, d) = 0.5 + scale * (unit(engine) - 0.5);
      columns.template at<Support>(i) = 0.02 * scale;
      ids(i) = i;
    }
  }
  void sort() {
    const ColumnNumbers memory("memory of the sort", static_cast<std::size_t>(Sorter<D>::rows) * columns.stride);
    Sorter<D> sorter(tree.n, memory, columns.stride);
    fit(tree, columns);
    sorter(columns.data, columns.stride, ids, tree.domain, bounds_of_all(tree));
    fit(tree, columns);
  }
};

template <int D>
Domain<D> unit_box(double period) {
  Domain<D> domain{};
  for (int d = 0; d < D; ++d) domain.period[d] = period;
  return domain;
}

template <class D>
struct CellTreeTest : testing::Test {};
using Dimensions =
    testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(CellTreeTest, Dimensions);

TYPED_TEST(CellTreeTest, SortingIsAPermutationThatKeepsRowsTogether) {
  constexpr int D = TypeParam::value;
  for (const int n : {1, 7, 64, 1000, 9000}) {
    Cloud<D> cloud(n, unit_box<D>(1), 1);
    std::map<std::uint64_t, double> x, h;
    for (int i = 0; i < n; ++i) {
      x[cloud.ids(i)] = cloud.columns.template at<Position>(i);
      h[cloud.ids(i)] = cloud.columns.template at<Support>(i);
    }
    cloud.sort();
    std::vector<std::uint64_t> seen(cloud.ids.data(), cloud.ids.data() + n);
    for (int i = 0; i < n; ++i) {
      ASSERT_EQ(cloud.columns.template at<Position>(i), x[cloud.ids(i)]);
      ASSERT_EQ(cloud.columns.template at<Support>(i), h[cloud.ids(i)]);
    }
    std::sort(seen.begin(), seen.end());
    for (int i = 0; i < n; ++i) ASSERT_EQ(seen[i], static_cast<std::uint64_t>(i));
  }
}

/// Particles with rows of all kinds, sorted in rows of their own columns or in other memory, and what stood in the rows
/// before.
template <int D>
struct RowsOfNumbers {
  using Fields = List<Position, Mass, InverseSupport, NumberDensity, NumberDensitySlope, Velocity>;
  static constexpr int n = 9001, rows = component_count<D, Fields>;
  Columns<D, Fields> columns{"rows", n};
  Ids ids{"ids", n};
  Kokkos::View<std::int64_t*, MemorySpace> begins{"begins", n};
  Kokkos::View<std::uint8_t*, MemorySpace> powers{"powers", n};
  std::vector<double> before;

  explicit RowsOfNumbers(bool lends_rows) {
    std::mt19937 engine(7);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int row = 0; row < rows; ++row)
      for (int i = 0; i < n; ++i) columns.data(row * columns.stride + i) = unit(engine);
    for (int i = 0; i < n; ++i) ids(i) = i, begins(i) = -i, powers(i) = static_cast<std::uint8_t>(i % 251);
    before.assign(columns.data.data(), columns.data.data() + columns.data.extent(0));
    const CellTree<D> tree(n, unit_box<D>(1));
    const auto first = static_cast<std::size_t>(component_offset<D, InverseSupport, Fields>) * columns.stride,
               length = static_cast<std::size_t>(Sorter<D>::rows) * columns.stride;
    const ColumnNumbers lent = Kokkos::subview(columns.data, std::pair(first, first + length)),
                        own("memory of the sort", length);
    Sorter<D> sorter(n, lends_rows ? lent : own, columns.stride);
    sorter(columns.data, columns.stride, ids, tree.domain, Bounds<D>{});
    sorter.permute(begins.data());
    sorter.permute(powers.data());
  }
};

/// Every row of 8 bytes or fewer is put in the new order in place, but for those in which the sort works; that order
/// does not hang on where it works.
TYPED_TEST(CellTreeTest, RowsArePermutedInPlace) {
  constexpr int D = TypeParam::value;
  using Rows = RowsOfNumbers<D>;
  const Rows own(false), lending(true);
  constexpr int first = component_offset<D, InverseSupport, typename Rows::Fields>;
  int moved = 0;
  for (int i = 0; i < Rows::n; ++i) {
    const auto source = static_cast<int>(own.ids(i));
    moved += source != i;
    ASSERT_EQ(lending.ids(i), own.ids(i));
    for (const Rows* rows : {&own, &lending}) {
      ASSERT_EQ(rows->begins(i), -source);
      ASSERT_EQ(rows->powers(i), source % 251);
      for (int row = 0; row < Rows::rows; ++row) {
        if (rows == &lending && row >= first && row < first + Sorter<D>::rows) continue;
        const auto start = static_cast<std::size_t>(row) * rows->columns.stride;
        ASSERT_EQ(rows->columns.data(start + i), rows->before[start + source]);
      }
    }
  }
  EXPECT_GT(moved, Rows::n / 2);
}

TYPED_TEST(CellTreeTest, BoxesHoldTheirParticles) {
  constexpr int D = TypeParam::value;
  Cloud<D> cloud(5000, unit_box<D>(0), 2);
  cloud.sort();
  for (int level = 0, size = sub_cell_size; level < cloud.tree.levels; ++level, size *= fan_out)
    for (int i = 0; i < cloud.tree.n; ++i) {
      const Bounds<D>& b = cloud.tree.node(level, i / size);
      ASSERT_LE(cloud.columns.template at<Support>(i), b.h_max);
      for (int d = 0; d < D; ++d) {
        ASSERT_GE(cloud.columns.template at<Position>(i, d), b.lo[d]);
        ASSERT_LE(cloud.columns.template at<Position>(i, d), b.hi[d]);
      }
    }
}

/// Every (particle, image) within reach lies in a sub-cell that the walk visits, once.
TYPED_TEST(CellTreeTest, AWalkMissesNothingAndVisitsNothingTwice) {
  constexpr int D = TypeParam::value;
  for (const double reach : {0.01, 0.3, 1.7}) {
    Cloud<D> cloud(D == 3 && reach > 1 ? 100 : 600, unit_box<D>(1), 3);
    cloud.sort();
    const Bounds<D> target = cloud.tree.node(0, 0);
    std::map<std::vector<long>, int> visits;
    const auto key = [](int sub_cell, const double* shift) {
      std::vector<long> k{sub_cell};
      for (int d = 0; d < D; ++d) k.push_back(std::lround(shift[d]));
      return k;
    };
    walk(
        cloud.tree, root(cloud.tree), target, [=](const auto& h) { return std::remove_cvref_t<decltype(h)>(reach); },
        [&](int sub_cell, const double* shift) { ++visits[key(sub_cell, shift)]; });
    for (const auto& [where, count] : visits) ASSERT_EQ(count, 1);
    const int most = static_cast<int>(reach) + 1, images = 2 * most + 1;
    for (int i = 0; i < cloud.tree.n; ++i)
      for (int image = 0; image < std::pow(images, D); ++image) {
        double shift[D], distance2 = 0;
        for (int d = 0, rest = image; d < D; ++d, rest /= images) {
          shift[d] = rest % images - most;
          const double x = cloud.columns.template at<Position>(i, d) + shift[d];
          const double gap = std::max({target.lo[d] - x, x - target.hi[d], 0.0});
          distance2 += gap * gap;
        }
        if (std::sqrt(distance2) < reach * (1 - 1e-12)) {
          ASSERT_EQ(visits.count(key(i / sub_cell_size, shift)), 1u) << "particle " << i;
        }
      }
  }
}

/// Cells are compact: the mean volume of a cell of 64 in an even gas stays near that of 64 particles.
TEST(CellTree, CellsOfAnEvenGasAreCompact) {
  constexpr int n = 32768;
  const Domain<3> domain = unit_box<3>(1);
  Cloud<3> cloud(n, domain, 4);
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < n; ++i)
    for (int d = 0; d < 3; ++d) cloud.columns.at<Position>(i, d) = unit(engine);
  cloud.sort();
  double sum = 0;
  for (int k = 0; k < cloud.tree.cells(); ++k) {
    const Bounds<3>& b = cloud.tree.node(1, k);
    sum += (b.hi[0] - b.lo[0]) * (b.hi[1] - b.lo[1]) * (b.hi[2] - b.lo[2]);
  }
  EXPECT_LT(sum, 1.2) << "volume of all boxes over the volume of the gas";
}

TEST(Domain, WrapsIntoItsBox) {
  Domain<2> domain{{-1, 0}, {2, 0}};
  EXPECT_EQ(domain.wrapped(1, 0), -1);
  EXPECT_EQ(domain.wrapped(-1.5, 0), 0.5);
  EXPECT_EQ(domain.wrapped(7.25, 0), -0.75);
  EXPECT_EQ(domain.wrapped(7.25, 1), 7.25) << "an open axis";
  const double wrapped = domain.wrapped(-1 - 1e-17, 0);
  EXPECT_GE(wrapped, -1);
  EXPECT_LT(wrapped, 1);
}

/// Neighbouring keys of a Hilbert curve are neighbouring cells: each step along it changes one coordinate by one.
TEST(Hilbert, CurveMovesOneCellAtATime) {
  constexpr int side = 8;  // the lowest 3 bits of each coordinate fill a cube, a contiguous piece of the curve
  std::map<std::uint64_t, std::array<int, 3>> cells;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z) {
        std::uint64_t a[3] = {std::uint64_t(x), std::uint64_t(y), std::uint64_t(z)};
        cells[hilbert_key<3>(a)] = {x, y, z};
      }
  ASSERT_EQ(cells.size(), 512u) << "keys are unique";
  EXPECT_EQ(cells.rbegin()->first - cells.begin()->first, 511u);
  for (auto it = cells.begin(), next = std::next(it); next != cells.end(); ++it, ++next) {
    int moved = 0;
    for (int d = 0; d < 3; ++d) moved += std::abs(it->second[d] - next->second[d]);
    ASSERT_EQ(moved, 1);
  }
}

TEST(RadixSort, SortsStably) {
  const ColumnNumbers memory("memory of the sort", RadixSort::rows * 50000);
  RadixSort sort(50000, memory.data(), 50000);
  std::mt19937_64 engine(6);
  std::vector<std::uint64_t> keys(50000);
  for (std::size_t i = 0; i < keys.size(); ++i) sort.keys(i) = keys[i] = engine() % 1000 << 40;
  sort.sort();
  std::vector<int> wanted(keys.size());
  std::iota(wanted.begin(), wanted.end(), 0);
  std::stable_sort(wanted.begin(), wanted.end(), [&](int a, int b) { return keys[a] < keys[b]; });
  for (std::size_t i = 0; i < keys.size(); ++i) ASSERT_EQ(sort.indices(i), wanted[i]);
}

}  // namespace
}  // namespace sphk::test
