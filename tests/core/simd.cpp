// SPDX-License-Identifier: BSD-3-Clause

// The pack vocabulary against the same operation lane by lane: the lanes are independent and every operation is exact
// or rounded once, so results are equal.
#include "kernels/core/simd.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "kernels/core/compress.hpp"

namespace sphk::test {
namespace {

template <class P>
struct Packs : testing::Test {
  using T = lane_t<P>;
  static constexpr int width = lanes<P>;
  std::vector<T> first, second;
  Packs() {
    for (int k = 0; k < width; ++k) first.push_back(T(k) - T(1.25)), second.push_back(T(3) - T(0.5) * T(k * k));
  }
  P pack(const std::vector<T>& from) const { return load<P>(from.data()); }
  std::vector<T> values(const P& from) const {
    std::vector<T> out(width);
    store(out.data(), from);
    return out;
  }
};

template <class T>
#ifdef SPHK_VECTOR_PACKS  // for hosts for which Kokkos has no packs, but they work on every host
using VectorPack = stdx::basic_simd<T, VectorAbi<16 / sizeof(T)>>;
#else
using VectorPack = T;
#endif

using PackTypes = testing::Types<float, double, simd<float, native_lanes<float>>, simd<double, native_lanes<double>>,
                                 VectorPack<float>, VectorPack<double>>;
TYPED_TEST_SUITE(Packs, PackTypes);

TYPED_TEST(Packs, OperationsActOnEachLane) {
  using P = TypeParam;
  const P a = this->pack(this->first), b = this->pack(this->second);
  const auto high = this->values(sphk::max(a, b)), low = this->values(sphk::min(a, b)),
             size = this->values(sphk::abs(a));
  const auto root = this->values(sphk::sqrt(a * a)), chosen = this->values(sphk::select(a < b, a, b));
  for (int k = 0; k < this->width; ++k) {
    EXPECT_EQ(high[k], std::max(this->first[k], this->second[k]));
    EXPECT_EQ(low[k], std::min(this->first[k], this->second[k]));
    EXPECT_EQ(size[k], std::abs(this->first[k]));
    EXPECT_EQ(root[k], std::abs(this->first[k]));
    EXPECT_EQ(chosen[k], this->first[k] < this->second[k] ? this->first[k] : this->second[k]);
  }
}

TYPED_TEST(Packs, ReductionsRunOverAllLanes) {
  using Number = lane_t<TypeParam>;
  Number sum = 0, most = this->second[0];
  for (const Number value : this->first) sum += value;  // quarters below 2^20: every order of the sum is exact
  for (const Number value : this->second) most = std::max(most, value);
  EXPECT_EQ(sum_lanes(this->pack(this->first)), sum);
  EXPECT_EQ(max_lanes(this->pack(this->second)), most);
}

TYPED_TEST(Packs, CompressionKeepsTheChosenLanesInOrder) {
  using P = TypeParam;
  using Number = lane_t<TypeParam>;
  const P a = this->pack(this->first);
  for (unsigned bits = 0; bits<1u << this->width; bits += this->width> 8 ? 37 : 1) {
    std::vector<Number> wanted, got(2 * this->width, Number(-99));
    for (int k = 0; k < this->width; ++k)
      if (bits >> k & 1) wanted.push_back(this->first[k]);
    const Compress<P> compress(bits);
    compress.store(got.data(), a);
    ASSERT_EQ(compress.count(), static_cast<int>(wanted.size()));
    got.resize(wanted.size());
    ASSERT_EQ(got, wanted) << "mask " << bits;
  }
}

TYPED_TEST(Packs, MaskBitsNameTheLanes) {
  unsigned wanted = 0;
  for (int k = 0; k < this->width; ++k) wanted |= unsigned(this->first[k] < this->second[k]) << k;
  EXPECT_EQ(mask_bits(this->pack(this->first) < this->pack(this->second)), wanted);
}

}  // namespace
}  // namespace sphk::test
