#include "src/cli/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "src/cli/stop_signal.hpp"
#include "src/engine/errors.hpp"

extern char** environ;

namespace sphk {

namespace fs = std::filesystem;

namespace {

constexpr int by_signal = 128;

pid_t start(std::vector<std::string> words, const fs::path& log) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  pid_t child = 0;
  const int error = posix_spawn(&child, words[0].c_str(), &files, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0)
    throw InputError(
        fmt::format("cannot start {} with its output in {}: may you write there?", words[0], log.string()));
  return child;
}

}  // namespace

int run_child(const std::vector<std::string>& arguments, const fs::path& log, const std::function<void()>& watch) {
  std::vector<std::string> words{fs::read_symlink("/proc/self/exe").string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const pid_t child = start(words, log);
  int status = 0;
  bool asked = false;
  for (int tick = 0; waitpid(child, &status, WNOHANG) == 0; ++tick) {
    if (stop_requested() && !asked) {
      kill(child, SIGTERM);
      asked = true;
    }
    if (watch && tick % 10 == 0) watch();
    std::this_thread::sleep_for(std::chrono::milliseconds(tick < 20 ? 5 : 50));
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : by_signal + WTERMSIG(status);
}

std::string reason_of(int code, const fs::path& log) {
  if (code == by_signal + SIGKILL) return "killed from outside: was there enough memory?";
  std::ifstream file(log);
  std::string line, last;
  while (std::getline(file, line))
    if (line.starts_with("error:"))
      return line.substr(7);
    else if (!line.empty())
      last = line;
  if (code > by_signal) return fmt::format("ended by signal {}", code - by_signal);
  return last.empty() ? fmt::format("exit code {}", code) : last;
}

double share_done(const fs::path& log) {
  std::ifstream file(log);
  double share = 0;
  for (std::string line; std::getline(file, line);) {
    const auto json = nlohmann::json::parse(line, nullptr, false);
    if (json.is_object() && json.contains("time") && json["end"] > 0)
      share = json["time"].get<double>() / json["end"].get<double>();
  }
  return std::clamp(share, 0.0, 1.0);
}

}  // namespace sphk
