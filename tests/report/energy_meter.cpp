// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/energy_meter.hpp"

#include <gtest/gtest.h>

#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

void write(const std::filesystem::path& folder, double energy, double range) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "energy_uj") << std::fixed << energy << "\n";
  std::ofstream(folder / "max_energy_range_uj") << std::fixed << range << "\n";
}

TEST(EnergyMeter, AddsTheProcessorsAndFollowsThemThroughZero) {
  const TemporaryFolder folder;
  const auto first = folder.path() / "intel-rapl:0", second = folder.path() / "intel-rapl:1";
  write(first, 900e6, 1000e6);
  write(second, 100e6, 1000e6);
  write(folder.path() / "intel-rapl:0:0", 0, 1000e6);  // the cores of the first: counted there already
  EnergyMeter meter(folder.path());
  EXPECT_DOUBLE_EQ(*meter.joules(), 0);
  write(first, 50e6, 1000e6);  // 100 J to its range, 50 J beyond
  write(second, 107e6, 1000e6);
  write(folder.path() / "intel-rapl:0:0", 60e6, 1000e6);
  EXPECT_DOUBLE_EQ(*meter.joules(), 157);
  write(first, 51e6, 1000e6);
  EXPECT_DOUBLE_EQ(*meter.joules(), 158);
}

TEST(EnergyMeter, SaysNothingWithoutCounters) {
  const TemporaryFolder folder;
  EXPECT_FALSE(EnergyMeter(folder.path()).joules());
  EXPECT_FALSE(EnergyMeter(folder.path() / "none").joules());
}

}  // namespace
}  // namespace sphk
