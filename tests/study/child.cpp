// SPDX-License-Identifier: BSD-3-Clause
#include "src/study/child.hpp"

#include <gtest/gtest.h>

#include <csignal>

#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

class Child : public testing::Test {
 protected:
  std::filesystem::path log(const std::string& text) const {
    const auto path = folder.path() / "log";
    std::ofstream(path) << text;
    return path;
  }
  TemporaryFolder folder;
};

TEST_F(Child, FailsForTheReasonInItsLog) {
  EXPECT_EQ(reason_of(2, log("{\"message\":\"error: not this\"}\n{\"error\":\"no\\nkernel\",\"exit_code\":2}\n")),
            "no\nkernel");
  EXPECT_EQ(reason_of(3, log("terminate called\n{\"error\": 1")), "exit code 3") << "half a line is none";
  EXPECT_EQ(reason_of(128 + SIGABRT, log("{\"message\":\"hello\"}\n")), "ended by signal 6");
  EXPECT_NE(reason_of(128 + SIGKILL, log("")).find("memory"), std::string::npos);
}

TEST_F(Child, TellsHowFarItIs) {
  EXPECT_EQ(share_done(log("")), 0);
  EXPECT_EQ(share_done(log("{\"time\":1,\"end\":8}\n{\"time\":2,\"end\":8}\nsome noise\n{\"message\":\"2\"}\n")), 0.25);
  EXPECT_EQ(share_done(log("{\"time\":9,\"end\":8}\n")), 1);
  EXPECT_EQ(share_done(folder.path() / "missing"), 0);
}

TEST_F(Child, IsHeardLast) {
  const auto path = log("{\"dry_run\":{\"steps\":1}}\n{\"dry_run\":{\"steps\":2}}\n[\"dry_run\"]\n");
  EXPECT_EQ(last_with("dry_run", path)["dry_run"]["steps"], 2);
  EXPECT_TRUE(last_with("steps", path).is_null());
}

// The executable that is run is this one, which lists its tests whatever else it is asked.
TEST_F(Child, RunsThisExecutableWithAJsonLog) {
  const auto path = folder.path() / "log";
  int calls = 0;
  EXPECT_EQ(run_child({"--gtest_list_tests"}, path, [&] { ++calls; }), 0);
  EXPECT_GE(calls, 1);
  EXPECT_NE(read_text(path).find("RunsThisExecutable"), std::string::npos);
}

}  // namespace
}  // namespace sphk
