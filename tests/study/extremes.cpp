// SPDX-License-Identifier: BSD-3-Clause
#include "src/study/extremes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/engine/errors.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

class ExtremesFile : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& text) {
    const auto path = folder.path() / "mine.toml";
    std::ofstream(path) << text;
    return path;
  }
  /// What the reader says about such a file; `check` as read_extremes has it.
  std::string complaint(const std::string& text, const CheckKeys& check = {}) {
    try {
      read_extremes(write(text), check);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  TemporaryFolder folder;
};

TEST_F(ExtremesFile, CasesTakeWhatStandsAboveThemUnlessTheySayOtherwise) {
  const auto cases = read_extremes(write(R"(scene = "tube"
[set]
scene = { problem = "blast", n = 64 }
[require]
unsound.below = 1
energy.below = 1e-3
[[case]]
name = "blast"
summary = "P 1000 beside 0.01"
[case.set]
sph = { scheme = "gadget2", neighbours = 4.5 }
time.limiter = false
[case.require]
front.below = 2
heat = "recorded"
[[case]]
name = "others-2.5"
scene = "noh"
set.scene.n = 32
require.energy = { above = -1, below = 2 }
)"));
  using Keys = std::vector<std::pair<std::string, std::string>>;
  ASSERT_EQ(cases.size(), 2u);
  EXPECT_EQ(cases[0].name, "blast");
  EXPECT_EQ(cases[0].summary, "P 1000 beside 0.01");
  EXPECT_EQ(cases[0].scene, "tube");
  EXPECT_EQ(cases[0].keys, (Keys{{"scene.problem", "blast"},
                                 {"scene.n", "64"},
                                 {"sph.scheme", "gadget2"},
                                 {"sph.neighbours", "4.5"},
                                 {"time.limiter", "false"}}));
  const auto texts = [](const ExtremeCase& one) {
    std::vector<std::string> all;
    for (const Requirement& requirement : one.requirements) all.push_back(requirement.text());
    return all;
  };
  EXPECT_EQ(texts(cases[0]), (std::vector<std::string>{"unsound < 1", "energy < 0.001", "front < 2", "heat recorded"}));
  EXPECT_EQ(cases[1].scene, "noh");
  EXPECT_EQ(cases[1].keys, (Keys{{"scene.problem", "blast"}, {"scene.n", "32"}}));
  EXPECT_EQ(texts(cases[1]), (std::vector<std::string>{"unsound < 1", "energy < 2 > -1"}));
}

TEST(Requirements, AreMetBetweenTheirBoundsAndByNumbersAlone) {
  const Requirement both{"energy", 2, 1}, none{"energy"};
  EXPECT_TRUE(both.met_by(1.5));
  for (const double wrong : {1.0, 2.0, 3.0, 0.0, std::nan("")}) EXPECT_FALSE(both.met_by(wrong)) << wrong;
  EXPECT_TRUE(none.met_by(-1e30));
  EXPECT_FALSE(none.met_by(std::nan("")));
}

TEST_F(ExtremesFile, SaysWhatIsWrongAndWhere) {
  const std::string start = "scene = \"sod\"\n[[case]]\nname = \"a\"\n";
  const std::pair<std::string, std::string> wrong[] = {
      {start + "settings.x = 1\n", "a case has no \"settings\""},
      {start + "set.scene.n = [1, 2]\n", "one number, string, true or false"},
      {start + "set = 1\n", "keys are wanted here"},
      {start + "require.energy.belwo = 1\n", "\"energy.belwo\" is no requirement"},
      {start + "require.energy = 1e-3\n", "energy.below = 1e-3"},
      {start + "require.energy.below = \"small\"\n", "not a number"},
      {start + "require.energy.below = nan\n", "not a number"},
      {start + "[[case]]\nname = \"a\"\n", "a second case \"a\""},
      {"norm = \"v\"\n" + start, "a file of extremes has no \"norm\""},
      {"scene = \"sod\"\n[case]\nname = \"a\"\n", "two brackets"},
      {"scene = \"sod\"\ncase = [1]\n", "not a case"},
      {"scene = \"sod\"\n[[case]]\nname = \"../a\"\n", "not a name of a case"},
      {"scene = \"sod\"\n[[case]]\nsummary = \"a\"\n", "a case without name or scene"},
      {"[[case]]\nname = \"a\"\n", "a case without name or scene"},
      {"scene = 1\n" + start.substr(14), "not a string"}};
  for (const auto& [text, words] : wrong) {
    const std::string said = complaint(text);
    EXPECT_NE(said.find(words), std::string::npos) << text << said;
    EXPECT_NE(said.find("mine.toml"), std::string::npos) << text << said;
    EXPECT_NE(said.find(" | "), std::string::npos) << text << said;  // the line
  }
  EXPECT_NE(complaint("scene = \"sod\"\n").find("write [[case]]"), std::string::npos);
  EXPECT_FALSE(complaint("scene = \"sod").empty());
}

TEST_F(ExtremesFile, ShowsWhatIsSaidAgainstSceneAndKeys) {
  const auto check = [](const std::string& scene, const KeyTexts& keys) {
    if (scene != "sod") throw InputError("no scene " + scene);
    for (const auto& [key, value] : keys)
      if (key != "scene.n" || value != "3") throw InputError(key + " = " + value + " is wrong");
  };
  const std::string start = "scene = \"sod\"\n[[case]]\nname = \"a\"\n";
  EXPECT_EQ(complaint(start + "set.scene.n = 3\n", check), "");
  for (const auto& [line, words] : {std::pair<std::string, std::string>("set.scene.m = 3", "scene.m = 3 is wrong"),
                                    {"set.scene.n = \"many\"", "scene.n = many is wrong"},
                                    {"scene = \"sodd\"", "no scene sodd"}}) {
    const std::string said = complaint(start + line + "\n", check);
    EXPECT_NE(said.find(words), std::string::npos) << line << said;
    EXPECT_NE(said.find(" 4 | " + line), std::string::npos) << line << said;
  }
}

}  // namespace
}  // namespace sphk
