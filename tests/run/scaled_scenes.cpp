// SPDX-License-Identifier: BSD-3-Clause

// The gas of every scene in units that are other powers of two, under the scene's own scheme: the same bits.
#include <gtest/gtest.h>

#include <algorithm>

#include "src/engine/host_columns.hpp"
#include "src/run/problem.hpp"
#include "src/schemes/registry.hpp"
#include "src/schemes/resolve.hpp"
#include "tests/compiled_schemes.hpp"
#include "tests/engine/units.hpp"

namespace sphk::test {
namespace {

constexpr Units units{0x1p100, 0x1p-61, 0x1p40};

/// Keys that make a scene small, in as few dimensions as it has.
KeyTexts small(const std::string& scene) {
  KeyTexts keys{{"scene.n", "16"}};
  const Settings known = resolve_problem(scene, {}).settings;
  if (known.has("scene.lattice")) keys.emplace_back("scene.lattice", "cubic");
  if (known.has("scene.dimension")) keys.emplace_back("scene.dimension", "2");
  if (scene == "sod" || scene == "sod-multimass" || scene == "tube") keys.emplace_back("scene.dimension", "1");
  if (scene == "blob" || scene == "noh" || scene == "expansion" || scene == "odd") keys.emplace_back("scene.n", "8");
  if (scene == "point-explosion") keys.emplace_back("scene.delay", "1e-3");
  return last_of_each(keys);
}

struct Case {
  std::string scene;
  KeyTexts keys;
  std::string name() const { return scene + (keys.empty() ? "" : " " + keys.back().first + "=" + keys.back().second); }
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const Scene* scene : scenes()) all.push_back({scene->name(), small(scene->name())});
  const auto add = [&](const std::string& scene, const std::string& key, const std::vector<std::string>& values) {
    for (const std::string& value : values) {
      all.push_back({scene, small(scene)});
      all.back().keys.emplace_back(key, value);
    }
  };
  add("odd", "scene.problem", {"one", "two", "ten", "plane", "ejected", "line"});
  add("tube", "scene.problem", {"strong-blast", "leblanc", "streams"});
  add("expansion", "scene.variant", {"slab"});
  add("ring", "gravity.softening", {"0.1"});
  add("kh18", "scene.masses", {"multi"});
  return all;
}

/// All numbers of the settings that have a unit, in the other ones.
SimulationSettings settings_in(SimulationSettings settings, int dimension, const Units& units) {
  const std::vector<const Number*>& numbers = scheme_entry(settings.scheme).numbers;
  settings = resolved(settings, dimension);
  settings.h_max *= units.length;
  settings.max_dt *= units.time;
  for (const Number* number : numbers) {
    const double in = factor(exponents(number->unit, dimension, settings.gamma), units);
    if (in != 1 && number->key != std::string("sph.h_max"))
      settings.numbers.set(number->key, settings.numbers[*number] * in);
  }
  return settings;
}

/// After two steps, the heat that the scene adds in mid-run, and three steps more.
Snapshot after_steps(const ParticleSet& gas, const SimulationSettings& settings, std::vector<HeatEvent> heat,
                     const Units& scale) {
  const auto run = make_simulation(gas, settings);
  const double energy = scale.mass * std::pow(scale.length / scale.time, 2);
  const double end = 1e3 * scale.time;  // particles that are alone come there in one step
  for (int step = 0; step < 5 && run->time() < end; ++step) {
    run->step(end);
    if (step != 1) continue;
    for (HeatEvent& event : heat) {
      for (double& x : event.place) x *= scale.length;
      run->heat(event.place, event.energy * energy);
    }
  }
  return run->snapshot();
}

TEST(ScaledScenes, GiveTheSameBits) {
  for (const char* scheme : {"sph", "gadget2", "sphs", "v10"})
    if (!is_compiled(scheme)) GTEST_SKIP();
  for (const Case& one : cases()) {
    const Problem problem = resolve_problem(one.scene, overrides_of(one.keys));
    const SimulationSettings settings = simulation_settings(problem.settings);
    const ParticleSet gas = problem.scene->build(problem.settings);
    const std::vector<HeatEvent> heat = problem.scene->heatings(problem.settings);
    EXPECT_EQ(heat.empty(), one.scene != "point-explosion");
    const Snapshot a = after_steps(gas, settings, heat, {1, 1, 1}),
                   b = after_steps(in_units(gas, units), settings_in(settings, gas.dimension, units), heat, units);
    EXPECT_EQ(b.time, a.time * units.time) << one.name();
    for (const char* name :
         {"Coordinates", "Velocities", "Masses", "Densities", "InternalEnergies", "Pressures", "SmoothingLength"}) {
      const Field &before = a.field(name), &after = b.field(name);
      const double in = factor(before.units, units);
      for (std::size_t k = 0; k < before.values.size(); ++k)
        ASSERT_EQ(after.values[k], before.values[k] * in) << one.name() << " " << name << " " << k;
    }
  }
}

}  // namespace
}  // namespace sphk::test
