// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/smoothing/list.hpp"

#include <gtest/gtest.h>

#include <set>

namespace sphk {
namespace {

TEST(KernelList, EveryNameFindsItsKernel) {
  const auto names = smoothing_kernel_names();
  for (const std::string& name : names)
    EXPECT_EQ(with_kernel(name, [](const auto& kernel) { return std::string(kernel.name); }), name);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
}

TEST(KernelList, LiqTakesACoreEdge) {
  const auto centre = [](const auto& kernel) { return kernel.w(0.0); };
  EXPECT_NEAR(with_kernel("liq0.6", centre), 0.8, 1e-15);  // F of V10 table 1
  EXPECT_NEAR(with_kernel("liq", centre), 0.65, 1e-15);
}

TEST(KernelList, UnknownNamesAreRefusedWithTheKnownOnes) {
  for (const char* name : {"cubic", "liq1.5", "liqx", "liq-1", "hoct6", ""}) {
    try {
      with_kernel(name, [](const auto&) {});
      FAIL() << name;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("hoct4"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace sphk
