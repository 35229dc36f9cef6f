#include "src/study/points.hpp"

#include <gtest/gtest.h>

#include <set>

#include "src/study/presets.hpp"

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
  EXPECT_EQ((StudyPoint{{{"scene.file", "../a b"}}}).name(), "file-.._a_b");
}

TEST(StudyPresets, HaveUnlikePointsWithResolutions) {
  for (const StudyPreset& preset : study_presets()) {
    std::set<std::string> names;
    for (const StudyPoint& point : preset.points) {
      EXPECT_NE(point.value(resolution_key), "") << preset.name;
      EXPECT_TRUE(names.insert(point.name()).second) << preset.name << ": " << point.name();
    }
    EXPECT_GT(names.size(), 1u) << preset.name;
  }
}

}  // namespace
}  // namespace sphk
