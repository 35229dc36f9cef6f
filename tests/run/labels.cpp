// SPDX-License-Identifier: BSD-3-Clause
#include "src/schemes/labels.hpp"

#include <gtest/gtest.h>

#include "src/run/problem.hpp"
#include "tests/compiled_schemes.hpp"

namespace sphk {
namespace {

TEST(Labels, StandForSchemeKernelAndNeighbours) {
  if (!is_compiled("tsph")) GTEST_SKIP();
  EXPECT_EQ(
      keys_of_label("SPHS-HCT442"),
      (KeyValues{
          {"sph.scheme", "sphs"}, {"sph.kernel", "hoct4"}, {"sph.neighbours", "442"}, {"sph.energy", "entropy"}}));
  EXPECT_EQ(keys_of_label("SPH-CS42"),
            (KeyValues{
                {"sph.scheme", "gadget2"}, {"sph.kernel", "cs"}, {"sph.neighbours", "42"}, {"sph.energy", "entropy"}}));
  EXPECT_EQ(keys_of_label("TSPH-HOCT4-442"),
            (KeyValues{
                {"sph.scheme", "tsph"}, {"sph.kernel", "hoct4"}, {"sph.neighbours", "442"}, {"sph.energy", "energy"}}));
  EXPECT_EQ(keys_of_label("OSPH-HOCT4-442"),
            (KeyValues{
                {"sph.scheme", "osph"}, {"sph.kernel", "hoct4"}, {"sph.neighbours", "442"}, {"sph.energy", "energy"}}));
  EXPECT_EQ((*keys_of_label("SPH-CS-128"))[0].second, "sph") << "R10 write a dash, and their SPH has no grad-h";
  EXPECT_EQ((*keys_of_label("SPH-WC2-100"))[2].second, "100");
  EXPECT_EQ((*keys_of_label("SPH-CS-128"))[3].second, "energy") << "R10 sec 3.2";
  EXPECT_EQ((*keys_of_label("SPHS-HOCT4-442"))[3].second, "entropy") << "S12's, written as R10 would";
  EXPECT_EQ(keys_of_label("SPHS-CT128e-multi-g"), (KeyValues{{"sph.scheme", "sphs-morris"},
                                                             {"sph.kernel", "ct"},
                                                             {"sph.neighbours", "128"},
                                                             {"sph.energy", "entropy"},
                                                             {"scene.masses", "multi"},
                                                             {"scene.lattice", "glass"}}));
  EXPECT_EQ(keys_of_label("SPHS-HCT442g"), keys_of_label("SPHS-HCT442-g")) << "S12 writes its suffixes without a dash";
}

TEST(Labels, LeaveSchemesAndMistakesAlone) {
  for (const char* text : {"sphs", "gadget2", "SPHS", "SPHS-XY42", "SPH-CS42e", "SPHS-HCT"})
    EXPECT_FALSE(keys_of_label(text)) << text;
}

TEST(Labels, AreTakenAsSchemesAndOtherOptionsWin) {
  if (!is_compiled("sphs-morris")) GTEST_SKIP();
  const Problem problem = resolve_problem(
      "gresho", {{"sph.neighbours", "300", "--neighbours"}, {"sph.scheme", "SPHS-HCT442e-g", "--scheme"}});
  EXPECT_EQ(problem.settings.text("sph.scheme"), "sphs-morris");
  EXPECT_EQ(problem.settings.text("sph.kernel"), "hoct4");
  EXPECT_EQ(problem.settings.real("sph.neighbours"), 300);
  EXPECT_EQ(problem.settings.text("scene.lattice"), "glass");
}

}  // namespace
}  // namespace sphk
