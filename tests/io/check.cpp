// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/check.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "src/engine/errors.hpp"

namespace sphk {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A row of n healthy particles in the periodic unit box.
ParticleSet healthy(std::size_t n) {
  ParticleSet p;
  p.box.periodic = {true, true, true};
  for (std::size_t i = 0; i < n; ++i) {
    p.x.push_back({(static_cast<double>(i) + 0.5) / static_cast<double>(n), 0.5, 0.5});
    p.v.push_back({0, 0, 0});
    p.m.push_back(1);
    p.u.push_back(1);
    p.id.push_back(100 + i);
  }
  return p;
}

/// The only finding of `p`; fails the test when there are none or several.
Finding only_finding(const ParticleSet& p) {
  const auto findings = check_particles(p);
  EXPECT_EQ(findings.size(), 1);
  return findings.empty() ? Finding{} : findings[0];
}

TEST(Check, HealthyParticlesHaveNoFindings) {
  EXPECT_TRUE(check_particles(healthy(10)).empty());
  EXPECT_TRUE(check_particles(ParticleSet{}).empty());
}

TEST(Check, FindsNonFiniteValuesInEveryColumn) {
  const auto finds = [](auto spoil) {
    ParticleSet p = healthy(5);
    p.h.assign(5, 0.1);
    spoil(p);
    const Finding finding = only_finding(p);
    return finding.severity == Finding::Severity::error && finding.count == 1 && finding.examples.at(0).index == 3;
  };
  EXPECT_TRUE(finds([](ParticleSet& p) { p.x[3][2] = nan; }));
  EXPECT_TRUE(finds([](ParticleSet& p) { p.v[3][0] = -std::numeric_limits<double>::infinity(); }));
  EXPECT_TRUE(finds([](ParticleSet& p) { p.m[3] = nan; }));
  EXPECT_TRUE(finds([](ParticleSet& p) { p.u[3] = nan; }));
  EXPECT_TRUE(finds([](ParticleSet& p) { p.h[3] = nan; }));
}

TEST(Check, FindsMassesAndEnergiesThatCannotBe) {
  ParticleSet p = healthy(6);
  p.m[1] = 0;
  p.m[4] = -1;
  const Finding masses = only_finding(p);
  EXPECT_EQ(masses.count, 2);
  EXPECT_EQ(masses.examples[0].id, 101);
  EXPECT_EQ(masses.examples[1].id, 104);
  p = healthy(6);
  p.u[2] = -1e-300;
  p.u[3] = 0;  // cold gas is fine
  EXPECT_EQ(only_finding(p).examples.at(0).index, 2);
}

TEST(Check, FindsNegativeSmoothingLengths) {
  ParticleSet p = healthy(6);
  p.h = {1, 1, 0, 1, -1, 1};  // 0 is to be found
  EXPECT_EQ(only_finding(p).examples.at(0).index, 4);
  EXPECT_EQ(only_finding(p).severity, Finding::Severity::error);
}

TEST(Check, FindsRepeatedIds) {
  ParticleSet p = healthy(6);
  p.id = {5, 9, 5, 7, 9, 5};
  const Finding finding = only_finding(p);
  EXPECT_EQ(finding.severity, Finding::Severity::error);
  EXPECT_EQ(finding.count, 3);  // rows 2 and 5 repeat row 0, row 4 repeats row 1
  EXPECT_EQ(finding.examples[0].index, 2);
  p.id.clear();
  EXPECT_TRUE(check_particles(p).empty());
}

TEST(Check, FindsCoincidentParticlesAlsoThroughThePeriodicBoundary) {
  ParticleSet p = healthy(6);
  p.x[0] = {0, 0.25, 0};
  p.x[5] = {1, 0.25, -0.0};
  const Finding finding = only_finding(p);
  EXPECT_EQ(finding.severity, Finding::Severity::notice);
  EXPECT_EQ(finding.count, 1);
  EXPECT_EQ(finding.examples[0].index, 5);
  p.box.periodic[0] = false;
  EXPECT_TRUE(check_particles(p).empty());
}

TEST(Check, FindsParticlesOutsideTheBoxInTheDimensionsThereAre) {
  ParticleSet p = healthy(4);
  p.x[2][1] = 1.25;
  EXPECT_EQ(only_finding(p).examples.at(0).x, p.x[2]);
  p.dimension = 1;
  EXPECT_TRUE(check_particles(p).empty());
}

// A few that left a periodic box are wrapped into it; when more than one in fifty is beyond the next box, the box has
// another unit than the positions. An open box holds nothing.
TEST(Check, ManyParticlesFarOutsideAPeriodicBoxAreAnError) {
  const auto severity = [](std::size_t count, double x, bool periodic) {
    ParticleSet p = healthy(100);
    p.box.periodic[0] = periodic;
    for (std::size_t i = 0; i < count; ++i) p.x[i][0] = x + static_cast<double>(i) / 1000;
    const Finding finding = only_finding(p);
    EXPECT_EQ(finding.count, count);
    return finding.severity;
  };
  EXPECT_EQ(severity(3, 2.5, true), Finding::Severity::error);
  EXPECT_EQ(severity(3, -1.5, true), Finding::Severity::error);
  EXPECT_EQ(severity(2, 2.5, true), Finding::Severity::notice);
  EXPECT_EQ(severity(90, 1.5, true), Finding::Severity::notice);
  EXPECT_EQ(severity(90, 2.5, false), Finding::Severity::notice);
}

TEST(Check, GasWithACoordinateInCommonNeedsADimension) {
  ReadResult content;
  content.particles = healthy(4);
  for (std::size_t i = 0; i < 4; ++i)
    content.particles.x[i] = {0.25 * static_cast<double>(i), 0.5 - 0.125 * static_cast<double>(i), 0.5};
  EXPECT_NE(dimension_in_doubt(content).find("the same z: say whether the gas is 2D"), std::string::npos);
  content.dimension_said = true;
  EXPECT_EQ(dimension_in_doubt(content), "");
  content = {};
  content.particles = healthy(4);
  EXPECT_NE(dimension_in_doubt(content).find("the same y and z: say whether the gas is 1D"), std::string::npos);
  for (Array3& x : content.particles.x) std::swap(x[0], x[1]);
  EXPECT_NE(dimension_in_doubt(content).find("gas of 1D lies along x"), std::string::npos);
  content.particles.x[1][0] = content.particles.x[2][2] = 0.25;
  EXPECT_EQ(dimension_in_doubt(content), "");
}

TEST(Check, OnlyAFewExamplesAreKept) {
  ParticleSet p = healthy(50);
  p.m.assign(50, -1.0);
  const Finding finding = only_finding(p);
  EXPECT_EQ(finding.count, 50);
  EXPECT_EQ(finding.examples.size(), 3);
}

TEST(Check, TextSaysCountIndexIdAndPosition) {
  ParticleSet p = healthy(4);
  p.m[1] = 0;
  EXPECT_EQ(to_text(only_finding(p)), "1 particle with zero or negative mass: row 1 (id 101) at (0.375, 0.5, 0.5)");
}

TEST(Check, ColumnsOfDifferentLengthsAreRefused) {
  ParticleSet p = healthy(4);
  p.u.pop_back();
  EXPECT_THROW(check_particles(p), InputError);
}

}  // namespace
}  // namespace sphk
