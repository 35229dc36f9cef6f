// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace sphk {

/// The file of this executable.
std::filesystem::path this_executable();

/// The machine that processes run on, as it names itself in its network.
std::string host_name();

/// Words as a shell takes them, in quotation marks where it needs some.
std::string shell_text(const std::vector<std::string>& words);
/// The words that this process was started with, as a shell takes them; empty where the machine does not tell.
std::string command_of_this_process();
/// What the user types to start this program: the environment's SPHK_COMMAND, or the first of these words.
std::string command_name();

/// When a process began, in ticks since the machine did; empty where there is none, or the machine does not tell.
std::string start_of_process(pid_t id);
/// Wall-clock seconds since this process began; 0 where the machine does not tell.
double age_of_this_process();

/// A program that this one has started, and waits for before it goes on.
class Process {
 public:
  struct Streams {
    std::FILE* input = nullptr;      ///< standard input, from where it stands; null: this process' own
    std::filesystem::path output{};  ///< a new file for standard output and error; empty: this process' own
    std::map<std::string, std::string> variables{};  ///< of its environment, beside this process' own
  };

  /// What `exit_code` says of a program that could not be started, as a shell does; and what it adds to the number of
  /// the signal that ended one.
  static constexpr int not_started = 127, by_signal = 128;

  /// `words`: the program, looked for in the PATH where it has no slash, and its arguments.
  Process(std::vector<std::string> words, const Streams& streams);
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process() { wait(); }

  /// Nothing while it runs.
  std::optional<int> exit_code();
  /// Its exit code, once it has ended.
  int wait();
  /// SIGTERM, as for a stop.
  void ask_to_stop() const;

 private:
  void take(int status);

  pid_t id_ = 0;
  std::optional<int> exit_code_;
};

}  // namespace sphk
