// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "src/engine/errors.hpp"
#include "src/schemes/registry.hpp"
#include "tests/compiled_schemes.hpp"
#include "tests/scenes/engine_keys.hpp"

namespace sphk {
namespace {

TEST(SceneTable, EverySceneIsFoundByItsName) {
  for (const Scene* scene : scenes()) {
    EXPECT_EQ(&find_scene(scene->name()), scene);
    EXPECT_LT(scene->summary().size(), 80u) << scene->name();
  }
}

TEST(SceneTable, UnknownNamesGetTheNearest) {
  try {
    find_scene("grecho");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("\"gresho\""), std::string::npos) << error.what();
  }
}

/// Every scene on a small lattice: n particles per unit length.
std::vector<std::pair<std::string, std::string>> small(const Scene& scene) {
  std::vector<std::pair<std::string, std::string>> keys{{"scene.n", "16"}};
  const Settings known = settings_of(scene);
  if (known.has("scene.lattice")) keys.emplace_back("scene.lattice", "cubic");
  if (known.has("scene.across")) keys.emplace_back("scene.across", "4");
  return keys;
}

TEST(SceneTable, ParticlesAreCompleteAndInTheBox) {
  for (const Scene* scene : scenes()) {
    const ParticleSet gas = scene->build(settings_of(*scene, small(*scene)));
    EXPECT_GT(gas.size(), 0u) << scene->name();
    EXPECT_EQ(gas.v.size(), gas.size()) << scene->name();
    EXPECT_EQ(gas.m.size(), gas.size()) << scene->name();
    EXPECT_EQ(gas.u.size(), gas.size()) << scene->name();
    EXPECT_TRUE(gas.tag.empty() || gas.tag.size() == gas.size()) << scene->name();
    EXPECT_TRUE(inside_box(gas)) << scene->name();
    for (int axis = gas.dimension; axis < 3; ++axis) EXPECT_FALSE(gas.box.periodic[axis]) << scene->name();
  }
}

// The initial condition is the exact solution at t = 0: velocity and, with P = (gamma-1) rho u, the thermal energy.
// A blast is a ball or a particle there and a point in the solution: only the gas outside of it is compared.
TEST(SceneTable, InitialConditionsEqualTheExactSolution) {
  for (const Scene* scene : scenes()) {
    const Settings settings = settings_of(*scene, small(*scene));
    const auto exact = scene->exact(settings);
    if (!exact) continue;
    const ParticleSet gas = scene->build(settings);
    for (std::size_t i = 0; i < gas.size(); ++i) {
      if (settings.has("scene.energy") && gas.u[i] > 1) continue;
      const GasState state = exact(gas.x[i], 0);
      EXPECT_NEAR(gas.u[i] * (settings.real("sph.gamma") - 1) * state.rho, state.P, 1e-12 * std::max(1.0, state.P))
          << scene->name() << ' ' << i;
      for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(gas.v[i][axis], state.v[axis], 1e-12) << scene->name();
    }
  }
}

TEST(SceneTable, TilesOfTheGallerySetKeysThatARunHas) {
  if (!is_compiled("sphs-morris")) GTEST_SKIP();
  for (const Scene* scene : scenes()) {
    Settings settings;
    declare_engine_keys(settings);
    settings.declare({.name = "time.end", .value = 1.0, .doc = "", .choices = {}});
    scene->declare(settings);
    for (const std::string& key : scene->gallery().keys) {
      const auto equals = key.find('=');
      EXPECT_NO_THROW(settings.set_from_text(key.substr(0, equals), key.substr(equals + 1), Origin::command_line))
          << scene->name() << ' ' << key;
    }
  }
}

TEST(SceneTable, ReferencesComeWithTheKeysThatAreSaidToBringThem) {
  for (const Scene* scene : scenes()) {
    const std::string text = scene->keys_with_references();
    if (text.empty()) continue;
    const auto equals = text.find('=');
    EXPECT_TRUE(scene->references(settings_of(*scene)).empty()) << scene->name();
    EXPECT_FALSE(scene->references(settings_of(*scene, {{text.substr(0, equals), text.substr(equals + 1)}})).empty())
        << scene->name();
  }
}

TEST(SceneTable, KeysThatTheUserSetStay) {
  for (const Scene* scene : scenes()) {
    const Settings settings = settings_of(*scene, {{"sph.gamma", "1.3"}, {"sph.neighbours", "33"}, {"time.end", "7"}});
    EXPECT_EQ(settings.real("sph.gamma"), 1.3) << scene->name();
    EXPECT_EQ(settings.real("sph.neighbours"), 33) << scene->name();
    EXPECT_EQ(settings.real("time.end"), 7) << scene->name();
  }
}

}  // namespace
}  // namespace sphk
