// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/scene_file.hpp"

#include <gtest/gtest.h>

#include "src/engine/errors.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

Settings example_settings() {
  Settings settings;
  settings.declare(
      {.name = "sph.kernel", .value = std::string("cs"), .doc = "smoothing kernel", .choices = {"cs", "hoct4"}});
  settings.declare(
      {.name = "sph.neighbours", .value = 48.0, .doc = "neighbour number", .choices = {}, .min = 1, .max = 1e6});
  settings.declare({.name = "time.steps", .value = std::int64_t{0}, .doc = "limit of steps", .choices = {}, .min = 0});
  settings.declare({.name = "scene.fast", .value = false, .doc = "a flag", .choices = {}});
  return settings;
}

class SceneFileTest : public testing::Test {
 protected:
  SceneFile file(const std::string& text) {
    std::ofstream(path()) << text;
    return SceneFile(path());
  }
  std::vector<std::string> problems(const std::string& text) { return file(text).apply(settings); }
  std::filesystem::path path() const { return folder.path() / "scene.toml"; }

  TemporaryFolder folder;
  Settings settings = example_settings();
};

TEST_F(SceneFileTest, SetsKeysOfSectionsAndOfDottedNames) {
  EXPECT_TRUE(problems("scene.name = \"sod\"\nscene.fast = true\ntime.steps = 7\n[sph]\nkernel = \"hoct4\"\n"
                       "neighbours = 442\n")
                  .empty());
  EXPECT_EQ(settings.text("sph.kernel"), "hoct4");
  EXPECT_EQ(settings.real("sph.neighbours"), 442);  // an integer where a real is wanted
  EXPECT_EQ(settings.integer("time.steps"), 7);
  EXPECT_TRUE(settings.flag("scene.fast"));
  EXPECT_EQ(settings.keys()[0].origin, Origin::file);
}

TEST_F(SceneFileTest, FindsTheSceneInBothSpellings) {
  EXPECT_EQ(std::get<std::string>(file("scene = \"sod\"\n").scene()->value), "sod");
  EXPECT_EQ(std::get<std::string>(file("[scene]\nname = \"noh\"\nfast = true\n").scene()->value), "noh");
  EXPECT_EQ(file("[sph]\nkernel = \"cs\"\n").scene(), nullptr);
}

// The key starts at column 3 of line 4; the caret below it stands after the "4 | " of the line shown.
TEST_F(SceneFileTest, AnUnknownKeyIsShownWithLineColumnCaretAndNearestName) {
  const auto found = problems("scene = \"sod\"\n\n[sph]\n  kernal = \"cs\"\n");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0], path().string() +
                          ":4:3: there is no key \"sph.kernal\"; did you mean \"sph.kernel\"?\n"
                          " 4 |   kernal = \"cs\"\n"
                          "   |   ^");
}

TEST_F(SceneFileTest, AWrongValueIsShownAtTheValue) {
  const auto found = problems("[sph]\nkernel = \"cubic\"\n");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].starts_with(path().string() + ":2:10: ")) << found[0];
  EXPECT_NE(found[0].find("choose one of cs, hoct4"), std::string::npos) << found[0];
  EXPECT_TRUE(found[0].ends_with("\n   |          ^")) << found[0];
}

TEST_F(SceneFileTest, AllErrorsComeInOnePass) {
  const auto found = problems(
      "[sph]\nkernal = \"cs\"\nneighbours = -3\n[time]\nsteps = \"many\"\nend_ = 1\n"
      "[scene]\nfast = [1, 2]\n");
  ASSERT_EQ(found.size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) {
    const int line[] = {2, 3, 5, 6, 8};
    EXPECT_NE(found[k].find(":" + std::to_string(line[k]) + ":"), std::string::npos) << found[k];
  }
}

TEST_F(SceneFileTest, AnUnknownSectionIsOneError) {
  const auto found = problems("[spc]\nkernel = \"cs\"\nneighbours = 3\n[sph]\nneighbours = 4\n");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].find(":1:2: there is no section [spc]; did you mean [sph]?"), std::string::npos) << found[0];
  EXPECT_EQ(settings.real("sph.neighbours"), 4);
}

TEST_F(SceneFileTest, BadTomlAndMissingFilesAreInputErrors) {
  EXPECT_THROW(file("scene = sod\n"), InputError);
  EXPECT_THROW(SceneFile(folder.path() / "missing.toml"), InputError);
  try {
    file("scene = \"sod\"\n[scene]\nfast = true\n");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("name = \"sod\" below [scene]"), std::string::npos) << error.what();
  }
}

TEST_F(SceneFileTest, TheUsedFileReadsBackToTheSameSettings) {
  settings.set("sph.neighbours", 0.1 + 0.2 + 50, Origin::command_line);
  settings.set("scene.fast", true, Origin::file);
  const std::string text = used_scene_file(settings, "sod");
  EXPECT_NE(text.find("# default; smoothing kernel"), std::string::npos) << text;
  EXPECT_NE(text.find("# from the command line; neighbour number"), std::string::npos) << text;
  const Settings before = settings;
  settings = example_settings();
  const SceneFile used = file(text);
  EXPECT_EQ(std::get<std::string>(used.scene()->value), "sod");
  EXPECT_TRUE(used.apply(settings).empty());
  for (std::size_t k = 0; k < before.keys().size(); ++k) EXPECT_EQ(settings.keys()[k].value, before.keys()[k].value);
}

TEST_F(SceneFileTest, TheUsedFileReadsBackWhateverItsStringsHold) {
  const std::string odd = "C:\\new \"folder\"\n\t\x01\x7f # \u00e9'";
  settings.declare({.name = "scene.file", .value = odd, .doc = "a path", .choices = {}});
  const std::string text = used_scene_file(settings, "file");
  settings.set("scene.file", std::string(), Origin::file);
  EXPECT_TRUE(problems(text).empty()) << text;
  EXPECT_EQ(settings.text("scene.file"), odd);
}

TEST_F(SceneFileTest, BytesThatAreNoTextAreInputErrors) {
  EXPECT_THROW(file("scene = \"sod\"\n[sph]\nkernel = 'hoc\x8c\xd4'\n"), InputError);
}

}  // namespace
}  // namespace sphk
