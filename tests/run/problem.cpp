// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/problem.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "src/engine/errors.hpp"
#include "tests/compiled_schemes.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

std::string message_of(const std::string& what, const std::vector<Override>& overrides = {}) {
  try {
    resolve_problem(what, overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Problem, EverySceneHasItsKeysAndAnEndTime) {
  for (const Scene* scene : scenes()) {
    const Problem problem = resolve_problem(scene->name(), {});
    EXPECT_EQ(problem.scene, scene);
    EXPECT_GT(problem.settings.real("time.end"), 0) << scene->name();
  }
}

TEST(Problem, TheCommandLineWinsOverTheFileAndTheFileOverTheScene) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "my.toml").string();
  std::ofstream(path) << "scene = \"sod\"\n[sph]\nneighbours = 60\ngamma = 1.5\n";
  const Problem problem = resolve_problem(path, {{"sph.neighbours", "70", "--neighbours 70"}});
  EXPECT_EQ(problem.settings.real("sph.neighbours"), 70);
  EXPECT_EQ(problem.settings.real("sph.gamma"), 1.5);
  EXPECT_EQ(problem.settings.real("time.end"), 0.2);  // sod's own
  const auto& keys = problem.settings.keys();
  EXPECT_EQ(std::ranges::find(keys, "sph.neighbours", &Key::name)->origin, Origin::command_line);
  EXPECT_EQ(std::ranges::find(keys, "sph.gamma", &Key::name)->origin, Origin::file);
}

TEST(Problem, ASceneAdaptsToWhatTheUserChose) {
  // R10's tube has gamma 1.4 (its sec 4.1), S12's 5/3.
  EXPECT_EQ(resolve_problem("sod", {{"scene.variant", "r10", "--set"}}).settings.real("sph.gamma"), 1.4);
  EXPECT_DOUBLE_EQ(resolve_problem("sod", {}).settings.real("sph.gamma"), 5.0 / 3);
}

TEST(Problem, ErrorsOfTheFileAndOfTheCommandLineComeTogether) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "my.toml").string();
  std::ofstream(path) << "scene = \"sod\"\n[sph]\nneighbors = 60\n";
  const std::string text =
      message_of(path, {{"sph.kernal", "cs", "--set sph.kernal=cs"}, {"time.end", "soon", "--t-end soon"}});
  EXPECT_NE(text.find("my.toml:3:1: there is no key \"sph.neighbors\"; did you mean \"sph.neighbours\"?"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("--set sph.kernal=cs: there is no key \"sph.kernal\"; did you mean \"sph.kernel\"?"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("--t-end soon: time.end = soon: a number is wanted here"), std::string::npos) << text;
}

TEST(Problem, AnUnknownSceneInAFileIsShownWithItsLine) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "my.toml").string();
  std::ofstream(path) << "# a tube\nscene = \"sodd\"\n";
  const std::string text = message_of(path);
  EXPECT_NE(text.find("my.toml:2:9: "), std::string::npos) << text;
  EXPECT_NE(text.find("sod"), std::string::npos) << text;
}

TEST(Problem, AnUnknownKernelIsRefusedBeforeAnythingIsComputed) {
  const std::string text = message_of("sod", {{"sph.kernel", "xx", "--kernel xx"}});
  EXPECT_NE(text.find("sph.kernel: there is no smoothing kernel \"xx\""), std::string::npos) << text;
  EXPECT_NE(text.find("hoct4"), std::string::npos) << text;
  EXPECT_EQ(message_of("sod", {{"sph.kernel", "liq0.4", "--kernel liq0.4"}}), "");
}

TEST(Problem, AFileWithoutASceneSaysHowToNameOne) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "my.toml").string();
  std::ofstream(path) << "[sph]\nneighbours = 60\n";
  EXPECT_NE(message_of(path).find("scene = \"sod\""), std::string::npos);
}

TEST(Problem, AMissingInitialConditionIsAnInputErrorThatNamesIt) {
  EXPECT_NE(message_of("missing.hdf5").find("missing.hdf5"), std::string::npos);
}

TEST(Problem, TakesTheChoicesOfThePaperByTheKeysThatAreSaidToBringThem) {
  if (!is_compiled("osph") || !is_compiled("sphs")) GTEST_SKIP();
  using Keys = std::vector<Override>;
  const std::pair<const char*, Keys> problems[] = {
      {"sod", {{"scene.variant", "r10", "a"}}},
      {"sod", {{"scene.variant", "v10", "a"}}},
      {"kh12", {{"scene.edges", "soft", "a"}, {"scene.dimension", "2", "b"}}}};
  std::vector<std::pair<std::string, Keys>> all(std::begin(problems), std::end(problems));
  for (const Scene* scene : scenes()) all.emplace_back(scene->name(), Keys{});
  for (auto& [name, keys] : all) {
    for (const PaperChoice& choice : departures(resolve_problem(name, keys)))
      for (const std::string& key : choice.keys) {
        const auto equals = key.find('=');
        std::erase_if(keys, [&](const Override& other) { return other.name == key.substr(0, equals); });
        keys.push_back({key.substr(0, equals), key.substr(equals + 1), key});
      }
    for (const PaperChoice& choice : departures(resolve_problem(name, keys)))
      EXPECT_TRUE(choice.keys.empty()) << name << ": " << choice.paper;
  }
}

TEST(Problem, KnowsWhatOfThePaperItDoesNotDo) {
  if (!is_compiled("osph") || !is_compiled("sphs")) GTEST_SKIP();
  const auto departs_by = [](const std::string& scene, const std::string& key, const std::vector<Override>& keys = {}) {
    return std::ranges::any_of(departures(resolve_problem(scene, keys)), [&](const PaperChoice& choice) {
      return std::ranges::find(choice.keys, key) != choice.keys.end();
    });
  };
  for (const char* scene : {"kh12", "kh18", "blob"})
    EXPECT_TRUE(departs_by(scene, "scene.temperatures=smoothed")) << scene;
  EXPECT_FALSE(departs_by("kh12", "scene.temperatures=smoothed", {{"sph.scheme", "osph", "--scheme"}}));
  EXPECT_FALSE(departs_by("kh18", "scene.n=256", {{"scene.n", "256", "-n"}}));
  EXPECT_TRUE(departs_by("kh18", "sph.scheme=SPHS-HCT442", {{"sph.energy", "energy", "--set"}}));
  EXPECT_TRUE(departs_by("shearing", "time.steps=individual"));
}

TEST(Problem, WithLatticeNeedsNoGlass) {
  const Problem problem = resolve_problem("sod", {});
  EXPECT_EQ(with_lattice(problem.settings).text("scene.lattice"), "cubic");
}

}  // namespace
}  // namespace sphk
