// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "src/engine/errors.hpp"
#include "tests/scenes/engine_keys.hpp"

namespace sphk {
namespace {

// 64 x 32 x 32 + 32 x 16 x 16 = 73,728 particles with spacings 1/64 and 1/32, all of mass 1/64^3.
TEST(Sod, DefaultCountsAreThePeers) {
  const ParticleSet gas = sod_scene.build(settings_of(sod_scene, {{"scene.lattice", "cubic"}}));
  EXPECT_EQ(gas.size(), 73728u);
  EXPECT_EQ(gas.box.size, (Array3{2, 0.5, 0.5}));
  for (const double m : gas.m) ASSERT_NEAR(m, std::pow(64, -3), 1e-18);
}

struct Variant {
  const char* name;
  const char* dimension;
  const char* lattice;
  double gamma, mass;  // of the box; per cross-section (4/16)^(D-1) at n = 16, across = 4
  std::size_t particles;
};

// Mass = (1 + rho_right) times the cross-section. 16 x 4 x 4 + 8 x 2 x 2 = 288 particles; 1D 16 + 2; V10's lattice
// 16 x 4 + 4 x 4.
TEST(Sod, VariantsHaveTheirStatesAndEqualMasses) {
  const Variant variants[] = {
      {"s12", "3", "cubic", 5.0 / 3, 1.125 / 16, 288}, {"r10", "3", "cubic", 1.4, 1.125 / 16, 288},
      {"s12", "1", "cubic", 5.0 / 3, 1.125, 18},       {"v10", "2", "cubic", 5.0 / 3, 1.25 / 4, 80},
      {"v10", "1", "glass", 5.0 / 3, 1.25, 20},
  };
  for (const Variant& variant : variants) {
    const Settings settings = settings_of(sod_scene, {{"scene.variant", variant.name},
                                                      {"scene.n", "16"},
                                                      {"scene.dimension", variant.dimension},
                                                      {"scene.across", "4"},
                                                      {"scene.lattice", variant.lattice}});
    const ParticleSet gas = sod_scene.build(settings);
    EXPECT_EQ(settings.real("sph.gamma"), variant.gamma) << variant.name;
    EXPECT_EQ(gas.size(), variant.particles) << variant.name;
    EXPECT_NEAR(total_mass(gas), variant.mass, 1e-13) << variant.name;
    for (const double m : gas.m) EXPECT_NEAR(m, gas.m[0], 1e-15) << variant.name;
  }
}

TEST(Sod, ChoosesTheDimensionAndNeighboursOfTheVariant) {
  EXPECT_EQ(settings_of(sod_scene, {{"scene.variant", "v10"}}).integer("scene.dimension"), 2);
  EXPECT_EQ(settings_of(sod_scene, {{"scene.variant", "v10"}}).real("sph.neighbours"), 32);
  EXPECT_EQ(settings_of(sod_scene).integer("scene.dimension"), 3);
  EXPECT_EQ(settings_of(sod_scene).real("time.end"), 0.2);
}

// S12 sec 7.2: one lattice, 2 x 16 x 4 x 4 particles, and the masses carry the density ratio of 8; so does V10's, of 4.
TEST(Sod, MultimassTubeIsEvenlySpaced) {
  const auto tube = [](const char* variant, const char* dimension) {
    return sod_multimass_scene.build(settings_of(sod_multimass_scene, {{"scene.n", "16"},
                                                                       {"scene.across", "4"},
                                                                       {"scene.lattice", "cubic"},
                                                                       {"scene.variant", variant},
                                                                       {"scene.dimension", dimension}}));
  };
  const ParticleSet gas = tube("s12", "3");
  ASSERT_EQ(gas.size(), 512u);
  EXPECT_NEAR(gas.m.front(), std::pow(16, -3), 1e-18);
  EXPECT_NEAR(gas.m.back(), std::pow(16, -3) / 8, 1e-18);
  EXPECT_NEAR(total_mass(gas), 1.125 / 16, 1e-13);
  EXPECT_EQ(gas.x.back()[0], 1 - 0.5 / 16);
  EXPECT_EQ(tube("v10", "2").size(), 128u);
  EXPECT_NEAR(total_mass(tube("v10", "2")), 1.25 / 4, 1e-13);
}

// V10 table 2: u = 1.5 and 1.
TEST(Sod, HasV10sEnergies) {
  const auto gas = sod_scene.build(settings_of(sod_scene, {{"scene.variant", "v10"}, {"scene.lattice", "cubic"}}));
  EXPECT_NEAR(gas.u.front(), 1.5, 1e-14);
  EXPECT_NEAR(gas.u.back(), 1, 1e-14);
}

TEST(Sod, RefusesCountsThatDoNotFit) {
  EXPECT_THROW(sod_scene.build(settings_of(sod_scene, {{"scene.n", "33"}})), InputError);
  EXPECT_THROW(sod_scene.build(settings_of(sod_scene, {{"scene.across", "5"}})), InputError);
  EXPECT_THROW(sod_scene.build(settings_of(sod_scene, {{"scene.dimension", "2"}})), InputError);
}

// Between contact and shock, 0.841 t < x < 1.844 t, rho = 0.229806; the image at x = 1 runs the other way.
TEST(Sod, ExactSolutionHasItsMirrorImage) {
  const auto exact = sod_scene.exact(settings_of(sod_scene));
  EXPECT_NEAR(exact({0.26, 0, 0}, 0.2).rho, 0.229806, 1e-6);
  EXPECT_NEAR(exact({0.74, 0, 0}, 0.2).rho, 0.229806, 1e-6);
  EXPECT_NEAR(exact({0.26, 0, 0}, 0.2).v[0], 0.841195, 1e-6);
  EXPECT_NEAR(exact({0.74, 0, 0}, 0.2).v[0], -0.841195, 1e-6);
  EXPECT_NEAR(exact({-0.9, 0, 0}, 0.2).rho, exact({-0.1, 0, 0}, 0.2).rho, 1e-12);
  EXPECT_EQ(exact({-0.5, 0, 0}, 0.2).rho, 1);
}

// Nothing by the means of bins and by particles; at the centres of bins only those with a jump or a bend.
TEST(Sod, TheExactSolutionHasNoErrors) {
  const Settings settings = settings_of(sod_scene, {{"scene.lattice", "cubic"}});
  const auto errors = sod_scene.errors(settings, exact_snapshot(sod_scene, settings, 0.2));
  EXPECT_EQ(errors.at("v_particles").l1, 0);
  EXPECT_EQ(errors.at("rho_particles").linf, 0);
  for (const char* field : {"v", "rho", "P"}) EXPECT_EQ(errors.at(field).linf, 0) << field;
  EXPECT_GT(errors.at("v_centres").l1, 0);
  EXPECT_LT(errors.at("v_centres").l1, 0.841195 / 100 + 0.005);
}

}  // namespace
}  // namespace sphk
