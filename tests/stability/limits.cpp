// SPDX-License-Identifier: BSD-3-Clause
#include "src/stability/limits.hpp"

#include <gtest/gtest.h>

namespace sphk {
namespace {

bool tells(const Contrasts& gas, const Method& method, const std::string& word) {
  for (const std::string& remark : limit_remarks(gas, method))
    if (remark.find(word) != std::string::npos) return true;
  return false;
}

TEST(Limits, AreToldWhereGasAndMethodMeetThem) {
  const Contrasts contact{.density = 120}, masses{.mass = 1000}, blast{.pressure = 1e5}, cold{.without_heat = 3};
  for (const char* scheme : {"sph", "tsph", "osph", "gadget2", "v10", "sphs"})
    EXPECT_TRUE(tells(contact, {scheme, "entropy"}, "1:120")) << scheme;
  for (const char* scheme : {"gadget2", "v10"}) EXPECT_TRUE(tells(masses, {scheme, "entropy"}, "1000")) << scheme;
  EXPECT_TRUE(tells(blast, {"sphs", "entropy"}, "1e+05"));
  for (const char* scheme : {"osph", "osph-coherent"}) EXPECT_TRUE(tells(cold, {scheme, "energy"}, "3 particles"));
  EXPECT_TRUE(tells({}, {"v10", "entropy", "v1"}, "cold gas to hot"));
  EXPECT_FALSE(tells({}, {"v10", "entropy", "v2"}, "run away"));
  EXPECT_TRUE(tells({}, {"v10", "entropy", "v2", false}, "run away"));
  for (const Contrasts& gas : {contact, masses, blast, cold})
    EXPECT_EQ(limit_remarks(gas, {}).size(), 1u) << "of a file that no scheme computes yet";
}

TEST(Limits, AreNoWordWhereTheyAreNotMet) {
  const Contrasts milder{.density = 70, .pressure = 90, .mass = 64};
  for (const char* scheme : {"", "sph", "osph-coherent", "gadget2", "v10", "sphs"})
    EXPECT_TRUE(limit_remarks(milder, {scheme, "entropy"}).empty()) << scheme;
  EXPECT_TRUE(limit_remarks({.density = 1e6}, {"osph-coherent", "energy"}).empty());
  EXPECT_TRUE(limit_remarks({.mass = 1e6}, {"sph", "energy"}).empty());
  EXPECT_TRUE(limit_remarks({.pressure = 1e6}, {"sphs", "energy"}).empty());
  EXPECT_TRUE(limit_remarks({.pressure = 1e6}, {"sphs-conservative", "entropy"}).empty());
  EXPECT_TRUE(limit_remarks({.without_heat = 10}, {"sphs", "entropy"}).empty());
}

}  // namespace
}  // namespace sphk
