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
  std::vector<T> a, b;
  Packs() {
    for (int k = 0; k < width; ++k) a.push_back(T(k) - T(1.25)), b.push_back(T(3) - T(0.5) * T(k * k));
  }
  P pack(const std::vector<T>& from) const { return load<P>(from.data()); }
  std::vector<T> values(const P& from) const {
    std::vector<T> out(width);
    store(out.data(), from);
    return out;
  }
};

using PackTypes = testing::Types<float, double, simd<float, native_lanes<float>>, simd<double, native_lanes<double>>>;
TYPED_TEST_SUITE(Packs, PackTypes);

TYPED_TEST(Packs, OperationsActOnEachLane) {
  using P = TypeParam;
  const P a = this->pack(this->a), b = this->pack(this->b);
  const auto high = this->values(sphk::max(a, b)), low = this->values(sphk::min(a, b)),
             size = this->values(sphk::abs(a));
  const auto root = this->values(sphk::sqrt(a * a)), chosen = this->values(sphk::select(a < b, a, b));
  for (int k = 0; k < this->width; ++k) {
    EXPECT_EQ(high[k], std::max(this->a[k], this->b[k]));
    EXPECT_EQ(low[k], std::min(this->a[k], this->b[k]));
    EXPECT_EQ(size[k], std::abs(this->a[k]));
    EXPECT_EQ(root[k], std::abs(this->a[k]));
    EXPECT_EQ(chosen[k], this->a[k] < this->b[k] ? this->a[k] : this->b[k]);
  }
}

TYPED_TEST(Packs, ReductionsRunOverAllLanes) {
  using T = typename TestFixture::T;
  T sum = 0, most = this->b[0];
  for (const T value : this->a) sum += value;  // quarters below 2^20: every order of the sum is exact
  for (const T value : this->b) most = std::max(most, value);
  EXPECT_EQ(sum_lanes(this->pack(this->a)), sum);
  EXPECT_EQ(max_lanes(this->pack(this->b)), most);
}

TYPED_TEST(Packs, CompressionKeepsTheChosenLanesInOrder) {
  using P = TypeParam;
  using T = typename TestFixture::T;
  const P a = this->pack(this->a);
  for (unsigned bits = 0; bits<1u << this->width; bits += this->width> 8 ? 37 : 1) {
    std::vector<T> wanted, got(2 * this->width, T(-99));
    for (int k = 0; k < this->width; ++k)
      if (bits >> k & 1) wanted.push_back(this->a[k]);
    const Compress<P> compress(bits);
    compress.store(got.data(), a);
    ASSERT_EQ(compress.count(), static_cast<int>(wanted.size()));
    got.resize(wanted.size());
    ASSERT_EQ(got, wanted) << "mask " << bits;
  }
}

TYPED_TEST(Packs, MaskBitsNameTheLanes) {
  unsigned wanted = 0;
  for (int k = 0; k < this->width; ++k) wanted |= unsigned(this->a[k] < this->b[k]) << k;
  EXPECT_EQ(mask_bits(this->pack(this->a) < this->pack(this->b)), wanted);
}

}  // namespace
}  // namespace sphk::test
