// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/process.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>

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

/// A shell makes the words again of what is told, whatever is in them; printf ends each with a zero byte.
TEST(Process, TellsWordsAsAShellTakesThem) {
  const TemporaryFolder folder;
  const auto out = folder.path() / "words";
  const std::vector<std::string> words{"plain", "", "two words", "it's", "$HOME;`ls`", "a\"b\\", "*", "n=16"};
  EXPECT_EQ(Process({"sh", "-c", "printf '%s\\0' " + shell_text(words)}, {.output = out}).wait(), 0);
  std::ifstream told(out);
  std::vector<std::string> again;
  for (std::string word; std::getline(told, word, '\0');) again.push_back(word);
  EXPECT_EQ(again, words);
  EXPECT_NE(command_of_this_process().find(this_executable().filename().string()), std::string::npos);
  EXPECT_FALSE(host_name().empty());
}

}  // namespace
}  // namespace sphk
