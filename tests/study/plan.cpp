// SPDX-License-Identifier: BSD-3-Clause
#include "src/study/plan.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "src/engine/errors.hpp"
#include "src/schemes/registry.hpp"
#include "src/study/others.hpp"
#include "tests/compiled_schemes.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

class StudyPlans : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& text) {
    const auto path = folder.path() / "mine.toml";
    std::ofstream(path) << text;
    return path;
  }
  /// What the reader says about such a file.
  std::string complaint(const std::string& text) {
    try {
      read_study_file(write(text));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  TemporaryFolder folder;
};

TEST_F(StudyPlans, AreReadInTheOrderOfTheFile) {
  const StudyPlan plan = read_study_file(write(R"(scene = "sod"
norm = "rho"
target = 0.5
budgets = [1, 60.5]
repeat = 2
others = "peers.csv"
[set]
scene = { lattice = "cubic", across = 4 }
time.limiter = false
[vary]
scene.n = [16, 32]
[[methods]]
sph.scheme = ["sph", "tsph"]
sph.neighbours = 48
[[methods]]
viscosity.alpha = 0.5
[[methods]]
scene.n = 64
)"));
  EXPECT_EQ(plan.name, "mine");
  EXPECT_EQ(plan.norm, "rho");
  EXPECT_EQ(plan.target, 0.5);
  EXPECT_EQ(plan.budgets, (std::vector<double>{1, 60.5}));
  EXPECT_EQ(plan.repeat, 2);
  EXPECT_EQ(plan.others, folder.path() / "peers.csv");
  using Keys = std::vector<std::pair<std::string, std::string>>;
  EXPECT_EQ(plan.fixed, (Keys{{"scene.lattice", "cubic"}, {"scene.across", "4"}, {"time.limiter", "false"}}));
  ASSERT_EQ(plan.points.size(), 7u) << "two schemes and another method at two resolutions, and one at its own";
  EXPECT_EQ(plan.points[6].keys, (Keys{{"scene.n", "64"}}));
  EXPECT_EQ(plan.points[1].keys, (Keys{{"sph.scheme", "sph"}, {"sph.neighbours", "48"}, {"scene.n", "32"}}));
  EXPECT_EQ(plan.points[2].keys, (Keys{{"sph.scheme", "tsph"}, {"sph.neighbours", "48"}, {"scene.n", "16"}}));
  EXPECT_EQ(plan.points[5].keys, (Keys{{"viscosity.alpha", "0.5"}, {"scene.n", "32"}}));
}

TEST_F(StudyPlans, SayWhatIsWrongAndWhere) {
  EXPECT_NE(complaint("scene = \"sod\"\nnrom = \"v\"\n").find("nrom"), std::string::npos);
  const std::string text = complaint("scene = \"sod\"\n[vary]\nscene.n = []\n");
  EXPECT_NE(text.find("empty list"), std::string::npos) << text;
  EXPECT_NE(text.find("3 |"), std::string::npos) << text;  // the line
  EXPECT_NE(complaint("scene = \"sod\"\ntarget = -1\n").find("positive"), std::string::npos);
  EXPECT_NE(complaint("scene = \"sod\"\n[methods]\nsph.scheme = \"sph\"\n").find("[[methods]]"), std::string::npos);
  EXPECT_NE(complaint("scene = \"sod\"\n[set]\nsph.kernel = [\"cs\"]\n").find("one number"), std::string::npos);
  EXPECT_NE(complaint("[vary]\nscene.n = [1]\n").find("names no scene"), std::string::npos);
  EXPECT_FALSE(complaint("scene = \"sod").empty());
}

// Twenty keys of four values each are a million million points, which no memory holds.
TEST_F(StudyPlans, WithMorePointsThanAnyoneRunsAreRefused) {
  std::string keys;
  for (char key = 'a'; key < 'u'; ++key) keys += std::string(1, key) + " = [1, 2, 3, 4]\n";
  for (const std::string section : {"[vary]\n", "[[methods]]\n"}) {
    const std::string text = complaint("scene = \"sod\"\n" + section + keys);
    EXPECT_NE(text.find("1.09951e+12 combinations"), std::string::npos) << text;
  }
}

TEST_F(StudyPlans, RepeatWholeNumbersOfTimes) {
  EXPECT_EQ(read_study_file(write("scene = \"sod\"\nrepeat = 3.0\n")).repeat, 3);
  for (const std::string number : {"1e300", "inf", "9223372036854775807", "1.5", "0", "nan"}) {
    const std::string text = complaint("scene = \"sod\"\nrepeat = " + number + "\n");
    EXPECT_NE(text.find("number"), std::string::npos) << number << ": " << text;
  }
}

TEST_F(StudyPlans, AreToldFromSceneFiles) {
  EXPECT_TRUE(is_study_file(write("scene = \"sod\"\n[vary]\nscene.n = [8]\n")));
  EXPECT_FALSE(is_study_file(write("[scene]\nname = \"sod\"\n")));
  EXPECT_FALSE(is_study_file("sod"));
}

TEST_F(StudyPlans, OfPresetsHaveUnlikePoints) {
  const auto presets = study_files_in(SPHK_STUDIES);
  EXPECT_GE(presets.size(), 6u);
  for (const StudyPlan& preset : presets) {
    std::set<std::string> names;
    for (const StudyPoint& point : preset.points)
      EXPECT_TRUE(names.insert(point.name()).second) << preset.name << point.name();
    EXPECT_GT(names.size(), 1u) << preset.name;
    EXPECT_FALSE(preset.summary.empty()) << preset.name;
    EXPECT_TRUE(preset.others.empty() || !read_others(preset.others).empty()) << preset.name;
  }
}

/// The settings of a preset's points.
std::vector<Problem> problems_of(const std::string& name) {
  const StudyPlan plan = read_study_file(std::filesystem::path(SPHK_STUDIES) / (name + ".toml"));
  std::vector<Problem> problems;
  for (const StudyPoint& point : plan.points) {
    KeyTexts keys = plan.fixed;
    keys.insert(keys.end(), point.keys.begin(), point.keys.end());
    problems.push_back(resolve_problem(plan.scene, overrides_of(keys)));
  }
  return problems;
}

TEST_F(StudyPlans, OfPresetsCanBeRun) {
  if (!is_compiled("sphs-morris")) GTEST_SKIP();
  for (const StudyPlan& preset : study_files_in(SPHK_STUDIES))
    for (const Problem& problem : problems_of(preset.name)) {
      const ParticleSet gas = problem.scene->build(with_lattice(problem.settings));
      EXPECT_GT(gas.size(), 0u) << preset.name;
      EXPECT_NO_THROW(describe(simulation_settings(problem.settings), gas)) << preset.name;
    }
}

// What the appendices vary, and on which problem.
TEST_F(StudyPlans, OfAppendicesAreTheirOwnProblems) {
  if (!is_compiled("sphs-morris") || !is_compiled("tsph")) GTEST_SKIP();
  const auto is_sphs = [](const Settings& s) {
    return s.text("sph.scheme") == "sphs" && s.text("sph.kernel") == "hoct4" && s.real("sph.neighbours") == 442 &&
           s.text("sph.energy") == "entropy" && s.real("time.courant") == 0.2 && s.text("time.steps") == "individual";
  };
  const auto strengths = [](const Settings& s) {
    return std::array{s.real("viscosity.alpha"), s.real("dissipation.entropy"), s.real("dissipation.mass")};
  };
  std::set<std::array<double, 3>> scanned, ablated;
  for (const Problem& p : problems_of("dissipation-scan")) {
    EXPECT_TRUE(is_sphs(p.settings) && p.settings.text("scene.lattice") == "cubic");
    EXPECT_EQ(p.scene->name(), "sod") << "S12 App. C";
    scanned.insert(strengths(p.settings));
  }
  EXPECT_EQ(scanned, (decltype(scanned){{0.1, 1, 1}, {1, 1, 1}, {5, 1, 1}, {1, 0.1, 1}, {1, 5, 1}}));
  for (const Problem& p : problems_of("ablation")) {
    EXPECT_TRUE(is_sphs(p.settings) && p.settings.text("scene.masses") == "multi");
    EXPECT_EQ(p.scene->name(), "kh18") << "S12 App. F";
    EXPECT_EQ(p.settings.text("scene.temperatures"), "smoothed");
    EXPECT_EQ(p.settings.integer("scene.dimension"), 3);
    ablated.insert(strengths(p.settings));
  }
  EXPECT_EQ(ablated, (decltype(ablated){{1, 0, 0}, {1, 1, 0}, {1, 1, 1}}));
  std::vector<double> neighbours;
  for (const Problem& p : problems_of("neighbour-scan")) {
    EXPECT_EQ(p.scene->name(), "kh12") << "R10 App. A";
    EXPECT_EQ(p.settings.text("sph.scheme") + p.settings.text("sph.kernel"), "tsphct");
    EXPECT_EQ(p.settings.text("sph.energy"), "energy");
    EXPECT_EQ(p.settings.text("scene.edges") + p.settings.text("scene.temperatures"), "sharpsmoothed");
    EXPECT_TRUE(p.settings.flag("output.errors"));
    neighbours.push_back(p.settings.real("sph.neighbours"));
  }
  EXPECT_EQ(neighbours, (std::vector<double>{32, 64, 128}));
  std::set<std::string> methods;
  for (const Problem& p : problems_of("gresho-convergence"))
    methods.insert(p.settings.text("sph.scheme") + " " + p.settings.text("sph.kernel") + " " +
                   to_text(p.settings.real("sph.neighbours")) + " " + p.settings.text("scene.lattice"));
  EXPECT_EQ(methods.size(), 7u) << "S12 Fig. 6";
}

TEST_F(StudyPlans, TakeOtherEnginesFromCsv) {
  const auto path = folder.path() / "others.csv";
  const auto complaint = [&](const std::string& text) -> std::string {
    std::ofstream(path) << text;
    try {
      read_others(path);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  std::ofstream(path)
      << "# measured last year\nmachine,error,engine, setting ,cpu_seconds\nA box, 0.5 ,SWIFT,48 neighbours,2e1\r\n";
  const auto points = read_others(path);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points[0].engine, "SWIFT");
  EXPECT_EQ(points[0].setting, "48 neighbours");
  EXPECT_EQ(points[0].error, 0.5);
  EXPECT_EQ(points[0].cpu, 20);
  EXPECT_EQ(points[0].machine, "A box");
  EXPECT_NE(complaint("# nothing but a remark\n").find("holds no table"), std::string::npos);
  EXPECT_THROW(read_others(folder.path()), InputError) << "a folder opens, but has no lines";
  EXPECT_NE(complaint("engine,error\n").find("no column \"setting\""), std::string::npos);
  const std::string head = "engine,setting,error,cpu_seconds,machine\n";
  EXPECT_NE(complaint(head + "a,b,0.1,2\n").find("others.csv:2: 4 values for 5 columns"), std::string::npos);
  EXPECT_NE(complaint(head + "a,b,zero,2,c\n").find("error is \"zero\""), std::string::npos);
  EXPECT_NE(complaint(head + "a,b,0.1,-2,c\n").find("cpu_seconds is \"-2\""), std::string::npos);
}

}  // namespace
}  // namespace sphk
