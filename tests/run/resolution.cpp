// SPDX-License-Identifier: BSD-3-Clause

// One resolver: the same scheme on the same gas computes the same, whoever asks, with a kernel and a neighbour number
// that belong together.
#include <gtest/gtest.h>

#include <algorithm>

#include "src/engine/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/snapshot_writer.hpp"
#include "src/run/problem.hpp"
#include "src/run/run_output.hpp"
#include "src/run/scene_file.hpp"
#include "src/scenes/initial_condition.hpp"
#include "src/schemes/registry.hpp"
#include "src/study/points.hpp"
#include "tests/compiled_schemes.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

std::vector<Override> overrides_of(const std::vector<std::pair<std::string, std::string>>& keys) {
  std::vector<Override> overrides;
  for (const auto& [name, text] : keys) overrides.push_back({name, text, "--set " + name + "=" + text});
  return overrides;
}

SimulationSettings settings_of(const std::string& what, const std::vector<std::pair<std::string, std::string>>& keys) {
  return simulation_settings(resolve_problem(what, overrides_of(keys)).settings);
}

void expect_equal(const SimulationSettings& a, const SimulationSettings& b, const std::string& who) {
  EXPECT_EQ(a.scheme, b.scheme) << who;
  EXPECT_EQ(a.kernel, b.kernel) << who;
  EXPECT_EQ(a.neighbours, b.neighbours) << who;
  EXPECT_EQ(a.precision, b.precision) << who;
  EXPECT_EQ(a.energy, b.energy) << who;
  EXPECT_EQ(a.gamma, b.gamma) << who;
  EXPECT_EQ(a.courant, b.courant) << who;
  EXPECT_EQ(a.steps, b.steps) << who;
  EXPECT_EQ(a.step_limiter, b.step_limiter) << who;
  for (const Number* number : scheme_entry(a.scheme).numbers)
    EXPECT_EQ(a.numbers[*number], b.numbers[*number]) << who << ' ' << number->key;
}

class Resolution : public testing::TestWithParam<std::tuple<std::string, int>> {};

TEST_P(Resolution, IsTheSameForCommandLineLibraryStudySceneFileAndContinuedSnapshot) {
  const auto& [scheme, D] = GetParam();
  const TemporaryFolder folder;
  const std::vector<std::pair<std::string, std::string>> keys{
      {"sph.scheme", scheme}, {"scene.dimension", std::to_string(D)}, {"scene.n", D == 1 ? "64" : "12"}};
  const Problem problem = resolve_problem("uniform", overrides_of(keys));
  const SimulationSettings command_line = simulation_settings(problem.settings);
  expect_equal(resolved({.scheme = scheme}, D), command_line, "library");

  const std::vector<StudyPoint> points = product_of(
      {{"sph.scheme", {scheme}}, {"scene.dimension", {std::to_string(D)}}, {"scene.n", {D == 1 ? "64" : "12"}}});
  ASSERT_EQ(points.size(), 1u);
  expect_equal(settings_of("uniform", points[0].keys), command_line, "study");

  write_atomically(folder.path() / "scene.toml", used_scene_file(problem.settings, "uniform"));
  expect_equal(settings_of((folder.path() / "scene.toml").string(), {}), command_line, "scene file");

  const ParticleSet gas = initial_condition(*problem.scene, problem.settings);
  const std::filesystem::path file = folder.path() / "snap.hdf5";
  write_snapshot(file, make_simulation(gas, command_line)->snapshot(), snapshot_info(*problem.scene, problem.settings));
  expect_equal(settings_of(file.string(), {{"time.end", "1"}}), command_line, "continued snapshot");
}

TEST_P(Resolution, RatesNameEveryFieldOnce) {
  const auto& [scheme, D] = GetParam();
  const Problem problem = resolve_problem("uniform", overrides_of({{"sph.scheme", scheme},
                                                                   {"scene.dimension", std::to_string(D)},
                                                                   {"scene.n", D == 1 ? "64" : "12"}}));
  SimulationSettings settings = simulation_settings(problem.settings);
  settings.precision = "double";
  settings.all_terms = true;
  const auto run = make_simulation(initial_condition(*problem.scene, problem.settings), settings);
  for (const bool split : {false, true}) {
    std::vector<std::string> names;
    for (const Field& field : run->rates(split)) names.push_back(field.name);
    std::ranges::sort(names);
    const auto twice = std::ranges::adjacent_find(names);
    EXPECT_TRUE(twice == names.end()) << *twice;
    EXPECT_TRUE(std::ranges::binary_search(names, "Acceleration"));
  }
}

INSTANTIATE_TEST_SUITE_P(EveryScheme, Resolution,
                         testing::Combine(testing::ValuesIn(scheme_names()), testing::Values(1, 2, 3)),
                         [](const auto& tested) {
                           std::string name =
                               std::get<0>(tested.param) + std::to_string(std::get<1>(tested.param)) + "D";
                           std::erase(name, '-');
                           return name;
                         });

struct Pair {
  std::string kernel;
  double neighbours;
};
Pair pair_of(const std::string& what, const std::vector<std::pair<std::string, std::string>>& keys) {
  const SimulationSettings settings = settings_of(what, keys);
  return {settings.kernel, settings.neighbours};
}
void expect_pair(const Pair& pair, const std::string& kernel, double neighbours) {
  EXPECT_EQ(pair.kernel, kernel);
  EXPECT_EQ(pair.neighbours, neighbours);
}

/// The scenes that prefer sphs take a classic scheme's own pair when it is asked for, not HOCT4 with its 48, in which a
/// lattice measures a density of 1.17.
TEST(KernelAndNeighbours, AreTheSchemesOwnWhereTheUserChoosesTheScheme) {
  if (!is_compiled("tsph")) GTEST_SKIP();
  for (const char* scene : {"kh12", "blob", "sod-multimass"})
    for (const char* scheme : {"sph", "tsph", "gadget2", "v10"})
      expect_pair(pair_of(scene, {{"sph.scheme", scheme}}), "cs", 48);
  for (const char* scheme : {"sph", "tsph", "gadget2"}) {
    for (const char* scene : {"mcnally", "ring"}) expect_pair(pair_of(scene, {{"sph.scheme", scheme}}), "cs", 20);
    expect_pair(pair_of("square", {{"sph.scheme", scheme}, {"scene.dimension", "2"}}), "cs", 20);
  }
  expect_pair(pair_of("kh12", {}), "hoct4", 442);
  expect_pair(pair_of("mcnally", {}), "wc6", 100);
  expect_pair(pair_of("tube", {{"sph.scheme", "sphs"}}), "wc4", 10);
  expect_pair(pair_of("tube", {{"sph.scheme", "gadget2"}}), "cs", 5);
}

/// What a scene prefers holds under the scheme that it prefers.
TEST(KernelAndNeighbours, OfAScenesOwnSchemeAreTheScenes) {
  expect_pair(pair_of("point-explosion", {}), "wc4", 200);
  expect_pair(pair_of("point-explosion", {{"sph.scheme", "gadget2"}}), "wc4", 200);
  expect_pair(pair_of("point-explosion", {{"sph.scheme", "sph"}}), "cs", 48);
  expect_pair(pair_of("shearing", {}), "liq", 32);
  expect_pair(pair_of("shearing", {{"sph.scheme", "sphs"}}), "wc6", 100);
}

/// A kernel that the user names brings the neighbours that it wants, where the scheme's own number is less; a number
/// that the user gives stands.
TEST(KernelAndNeighbours, FollowTheUsersKernel) {
  expect_pair(pair_of("uniform", {{"sph.scheme", "gadget2"}, {"sph.kernel", "wc6"}}), "wc6", 300);
  expect_pair(pair_of("uniform", {{"sph.scheme", "gadget2"}, {"sph.kernel", "hoct4"}}), "hoct4", 442);
  expect_pair(pair_of("uniform", {{"sph.scheme", "sphs"}, {"sph.kernel", "wc2"}}), "wc2", 442);
  expect_pair(pair_of("uniform", {{"sph.scheme", "gadget2"}, {"sph.kernel", "wc6"}, {"sph.neighbours", "99"}}), "wc6",
              99);
}

std::string label_message_of(const std::string& what, const std::vector<std::pair<std::string, std::string>>& keys) {
  try {
    resolve_problem(what, overrides_of(keys));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Keys, OfAnotherSchemeAreErrorsThatNameTheSchemesThatHaveThem) {
  if (!is_compiled("tsph")) GTEST_SKIP();
  const std::string beta = label_message_of("sod", {{"sph.scheme", "gadget2"}, {"viscosity.beta", "7"}});
  for (const char* word : {"viscosity.beta", "gadget2", "sph", "tsph", "osph", "v10"})
    EXPECT_NE(beta.find(word), std::string::npos) << word << ": " << beta;
  const std::string noise = label_message_of("kh12", {{"sph.scheme", "tsph"}, {"switch.noise", "0.1"}});
  for (const char* word : {"switch.noise", "tsph", "sphs", "sphs-morris"})
    EXPECT_NE(noise.find(word), std::string::npos) << word << ": " << noise;
}

TEST(Keys, OfASchemeHaveItsOwnDefaults) {
  const auto value = [](const char* scheme, const char* key) {
    return resolve_problem("uniform", overrides_of({{"sph.scheme", scheme}})).settings.real(key);
  };
  EXPECT_EQ(value("sph", "viscosity.beta"), 2);
  EXPECT_EQ(value("v10", "viscosity.beta"), 1.5);
  EXPECT_EQ(value("sph", "time.courant"), 0.4);
  EXPECT_EQ(value("gadget2", "time.courant"), 0.2);
  EXPECT_FALSE(resolve_problem("uniform", overrides_of({{"sph.scheme", "gadget2"}})).settings.has("viscosity.beta"));
}

}  // namespace
}  // namespace sphk
