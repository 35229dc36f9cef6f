#include "src/report/process.hpp"

#include <gtest/gtest.h>

#include <csignal>

#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

TEST(Process, EndsWithItsExitCodeOrSignal) {
  EXPECT_EQ(Process({"sh", "-c", "exit 3"}, {}).wait(), 3);
  EXPECT_EQ(Process({"sh", "-c", "kill -KILL $$"}, {}).wait(), Process::by_signal + SIGKILL);
  EXPECT_EQ(Process({"/nonexistent/program"}, {}).wait(), Process::not_started);
  EXPECT_EQ(Process({"sh", "-c", "exit 0"}, {.output = "/nonexistent/folder/log"}).wait(), Process::not_started);
}

TEST(Process, ReadsAndWritesFiles) {
  const TemporaryFolder folder;
  std::FILE* input = std::tmpfile();
  std::fputs("skipped\nsaid", input);
  std::fflush(input);
  std::fseek(input, 8, SEEK_SET);
  const auto log = folder.path() / "log";
  std::ofstream(log) << "something longer that was there before";
  EXPECT_EQ(Process({"sh", "-c", "cat; echo ' and done' >&2"}, {.input = input, .output = log}).wait(), 0);
  EXPECT_EQ(read_text(log), "said and done\n");
  std::fclose(input);
}

TEST(Process, StopsWhenItIsAskedTo) {
  Process sleeper({"sleep", "1000"}, {});
  EXPECT_FALSE(sleeper.exit_code());
  sleeper.ask_to_stop();
  EXPECT_EQ(sleeper.wait(), Process::by_signal + SIGTERM);
  EXPECT_EQ(sleeper.exit_code(), Process::by_signal + SIGTERM);
}

TEST(Process, KnowsItsOwnFile) {
  EXPECT_EQ(this_executable().filename(), "report");
}

}  // namespace
}  // namespace sphk
