// SPDX-License-Identifier: BSD-3-Clause

// `sphk extremes`: what it reads, runs and requires.
#include "src/study/extremes.hpp"

#include <set>

#include "src/run/problem.hpp"
#include "tests/cli/sphk_executable.hpp"

namespace sphk {
namespace {

class Extremes : public Executable {
 protected:
  void write(const std::string& text) const { std::ofstream(file("mine.toml")) << text; }
};

/// Even gas at rest keeps its energy, and has no number of this name.
constexpr const char* still = R"(scene = "uniform"
[set]
scene.lattice = "cubic"
scene.n = 6
time.end = 0.01
[require]
unsound.below = 1
threads.below = 1e-12
[[case]]
name = "still"
summary = "even gas at rest"
require = { energy.below = 1e-6, max_rho = { above = 0.9, below = 1.1 }, step = "recorded" }
)";

TEST_F(Extremes, OfAFileAreRunAndHeldAgainstTheirBounds) {
  write(still);
  expect("extremes mine.toml --threads 1", 0,
         {"even gas at rest", "unsound < 1", "threads < 1e-12", "energy < 1e-06", "max_rho < 1.1 > 0.9",
          "step recorded", "1 of 1 cases pass"});
  EXPECT_NE(read_text(file("extremes/extremes.txt")).find("energy < 1e-06"), std::string::npos);
}

TEST_F(Extremes, ThatMissABoundOrDoNotFinishEndWithCode3) {
  write(std::string(still) +
        "[[case]]\nname = \"bound\"\nrequire.max_rho.above = 2\n"
        "[[case]]\nname = \"unknown\"\nrequire.nearst.below = 1\n"
        "[[case]]\nname = \"stuck\"\nset.sph.neighbours = 1\n");
  expect("extremes mine.toml", 3,
         {"still ... pass", "bound ... FAIL", "unknown ... FAIL", "no number \"nearst\"; did you mean \"nearest\"?",
          "stuck ... FAIL", "the particle itself", "1 of 4 cases pass"});
  expect("extremes mine.toml still", 0, {"1 of 1 cases pass"});
  expect("extremes mine.toml stil", 2, {"there is no case \"stil\"; known are still, bound, unknown, stuck"});
}

TEST_F(Extremes, WithWrongKeysOrValuesAreRefusedBeforeAnythingRuns) {
  const auto refused = [&](const std::string& line, const std::string& words) {
    write(std::string(still) + "[[case]]\nname = \"wrong\"\n" + line + "\n");
    expect("extremes mine.toml", 2, {words, "mine.toml", "15 |", " here"});
  };
  refused("set.sph.kernal = \"cs\"", "did you mean \"sph.kernel\"?");
  refused("set.sph.neighbours = \"many\"", "a number is wanted");
  refused("set = { sph.scheme = \"gadget2\", viscosity.beta = 1 }", "viscosity.beta is no key of the scheme gadget2");
  refused("scene = \"unifrom\"", "uniform");
  EXPECT_FALSE(std::filesystem::exists(file("extremes")));
}

/// Defaults may change; what an extreme run computes may not.
TEST(ExtremesOfSphk, SayInFullWhatTheyRunAndHaveBounds) {
  std::set<std::string> names;
  const auto check = [](const std::string& scene, const KeyTexts& keys) { resolve_problem(scene, overrides_of(keys)); };
  for (const ExtremeCase& one : extremes_in(SPHK_STUDIES "/extremes", check)) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_FALSE(one.summary.empty()) << one.name;
    for (const std::string key :
         {"sph.scheme", "sph.kernel", "sph.neighbours", "sph.energy", "sph.precision", "time.courant", "time.steps"})
      EXPECT_EQ(std::ranges::count(one.keys, key, &std::pair<std::string, std::string>::first), 1)
          << one.name << " " << key;
    std::set<std::string> required;
    for (const Requirement& requirement : one.requirements) required.insert(requirement.quantity);
    EXPECT_TRUE(required.contains("unsound") && required.contains("threads")) << one.name;
    EXPECT_GT(required.size(), 2u) << one.name;
  }
  EXPECT_GT(names.size(), 40u);
}

}  // namespace
}  // namespace sphk
