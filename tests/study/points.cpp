// SPDX-License-Identifier: BSD-3-Clause
#include "src/study/points.hpp"

#include <gtest/gtest.h>

namespace sphk {
namespace {

TEST(StudyPoints, AreEveryCombination) {
  const auto points =
      product_of({{"sph.scheme", {"sph", "sphs"}}, {"sph.kernel", {}}, {"scene.n", {"16", "32", "64"}}});
  ASSERT_EQ(points.size(), 6u);
  EXPECT_EQ(points[1].value("scene.n"), "32");
  EXPECT_EQ(points[3].value("sph.scheme"), "sphs");
  EXPECT_EQ(points[3].value("sph.kernel"), "") << "an axis without values is left out";
  EXPECT_EQ(product_of({}).size(), 1u) << "the scene as it is";
}

TEST(StudyPoints, AreNamedByWhatTheyVary) {
  const StudyPoint point{{{"sph.scheme", "sphs"}, {"scene.n", "32"}, {"sph.kernel", "liq0.4"}}};
  EXPECT_EQ(point.method(), "sphs liq0.4");
  EXPECT_EQ((StudyPoint{{{"sph.scheme", "sphs"}, {"viscosity.alpha", "0"}}}).method(), "sphs viscosity.alpha=0");
  EXPECT_EQ(point.name(), "scheme-sphs_n-32_kernel-liq0.4");
  EXPECT_NE((StudyPoint{{{"viscosity.alpha", "1"}}}).name(), (StudyPoint{{{"switch.alpha", "1"}}}).name());
  EXPECT_EQ((StudyPoint{{{"scene.file", "../a b"}}}).name(), "file-.._a_b");
}

}  // namespace
}  // namespace sphk
