// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <stdio.h>
#include <sys/wait.h>

#include <string>
#include <vector>

#include "tests/temporary_folder.hpp"

namespace sphk {

/// What a command came to.
struct CommandResult {
  int code = -1;     ///< exit code; 128 and the number of the signal that ended it; 124 where it took too long
  std::string text;  ///< standard output and error together
};

/// Tests that start `sphk ARGUMENTS` in a folder of their own. None may take longer than five minutes.
class Executable : public testing::Test {
 protected:
  using Result = CommandResult;

  Result sphk(const std::string& arguments) const {
    const std::string command =
        "cd '" + folder.path().string() + "' || exit 1; timeout -k 5 300 '" SPHK_EXECUTABLE "' " + arguments + " 2>&1";
    FILE* pipe = popen(command.c_str(), "r");
    Result result;
    for (int c = fgetc(pipe); c != EOF; c = fgetc(pipe)) result.text += static_cast<char>(c);
    const int status = pclose(pipe);
    result.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return result;
  }
  /// The command ends with that code and prints all of these words.
  void expect(const std::string& arguments, int code, const std::vector<std::string>& words) const {
    const Result result = sphk(arguments);
    EXPECT_EQ(result.code, code) << "sphk " << arguments << "\n" << result.text;
    for (const std::string& part : words)
      EXPECT_NE(result.text.find(part), std::string::npos) << part << "\nsphk " << arguments << "\n" << result.text;
  }
  std::filesystem::path file(const std::string& name) const { return folder.path() / name; }
  TemporaryFolder folder;
};

}  // namespace sphk
