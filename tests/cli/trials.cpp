#include "src/cli/trials.hpp"

#include <gtest/gtest.h>

#include <set>

#include "src/cli/plain_file.hpp"
#include "src/io/reader.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

TEST(Trials, AreNamedOnceAndBesideTheRuns) {
  std::set<std::string> names;
  for (const ExtremeCase& one : extreme_cases()) names.insert(one.name);
  for (const Trial& one : further_trials()) EXPECT_TRUE(names.insert(one.name).second) << one.name;
}

// The executable that is run is this one: it lists its tests and ends with 0.
TEST(Trials, ACommandHasToComeToWhatIsExpectedOfIt) {
  const TemporaryFolder folder;
  const Workshop shop{folder.path()};
  const std::vector<std::string> list{"--gtest_list_tests"};
  const Command right{list, 0, {"Trials.", "ACommandHasTo"}}, wrong_code{list, 2},
      silent{list, 0, {"Trials.", "no such words"}}, talkative{list, 0, {}, {"Trials."}};
  const Outcome good = try_commands("lists its tests", {right, right}, shop);
  EXPECT_TRUE(good.passed);
  EXPECT_EQ(good.required, "lists its tests");
  EXPECT_EQ(good.found, "2 of 2");
  const auto found = [&](const Command& command) {
    const Outcome outcome = try_commands("", {right, command, right}, shop);
    EXPECT_FALSE(outcome.passed);
    EXPECT_TRUE(outcome.found.starts_with("2 of 3; ")) << outcome.found;
    return outcome.found;
  };
  EXPECT_NE(found(wrong_code).find("(sphk --gtest_list_tests): exit code 0"), std::string::npos);
  EXPECT_NE(found(silent).find("does not say \"no such words\""), std::string::npos);
  EXPECT_NE(found(talkative).find("says \"Trials.\""), std::string::npos);
}

TEST(PlainFile, IsReadAsItWasGiven) {
  const TemporaryFolder folder;
  ParticleSet gas;
  gas.dimension = 2;
  gas.box = {{0, 0, 0}, {2, 0.5, 1}, {true, true, false}};
  gas.x = {{0.25, 0.125, 0}, {1.5, 0.25, 0}};
  gas.v = {{1, 2, 0}, {3, 4, 0}};
  gas.m = {5, 6};
  gas.u = {7, 8};
  gas.h = {0.5, 0.75};
  write_plain_file(folder.path() / "gas.hdf5", gas);
  const ReadResult read = read_particles(folder.path() / "gas.hdf5");
  const ParticleSet& p = read.particles;
  EXPECT_FALSE(read.own_snapshot);
  EXPECT_EQ(p.dimension, 2);
  EXPECT_EQ(p.box.size, gas.box.size);
  EXPECT_EQ(p.box.periodic, gas.box.periodic);
  EXPECT_EQ(p.x, gas.x);
  EXPECT_EQ(p.v, gas.v);
  EXPECT_EQ(p.m, gas.m);
  EXPECT_EQ(p.u, gas.u);
  EXPECT_EQ(p.h, gas.h);
  EXPECT_EQ(p.id, (std::vector<std::uint64_t>{1, 2}));
}

}  // namespace
}  // namespace sphk
