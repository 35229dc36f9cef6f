// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <sstream>

extern char** environ;

namespace sphk {

namespace fs = std::filesystem;

fs::path this_executable() {
  return fs::read_symlink("/proc/self/exe");
}

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "an unknown host";
}

std::string shell_text(const std::vector<std::string>& words) {
  std::string text;
  for (std::string word : words) {
    const auto special = " \t\n\"'\\$&|;<>()*?[]{}#~`!";
    if (word.empty() || word.find_first_of(special) != std::string::npos) {
      for (std::size_t k = 0; (k = word.find('\'', k)) != std::string::npos; k += 4) word.replace(k, 1, "'\\''");
      word = "'" + word + "'";
    }
    text += (text.empty() ? "" : " ") + word;
  }
  return text;
}

namespace {

std::vector<std::string> words_of_this_process() {
  std::ifstream file("/proc/self/cmdline");  // proc(5): every word ends with a zero byte
  std::vector<std::string> words;
  for (std::string word; std::getline(file, word, '\0');) words.push_back(word);
  return words;
}

}  // namespace

std::string command_of_this_process() {
  return shell_text(words_of_this_process());
}

std::string command_name() {
  if (const char* name = std::getenv("SPHK_COMMAND")) return name;
  const std::vector<std::string> words = words_of_this_process();
  return words.empty() ? "sphk" : shell_text({words.front()});
}

std::string start_of_process(pid_t id) {
  std::ifstream file("/proc/" + std::to_string(id) + "/stat");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto name_end = text.rfind(')');  // proc(5): field 2 is the name, in brackets, field 22 the start
  if (name_end == std::string::npos) return "";
  std::istringstream fields(text.substr(name_end + 1));
  std::string field;
  for (int number = 3; number <= 22; ++number) fields >> field;
  return field;
}

double age_of_this_process() {
  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  const double ticks = std::strtod(start_of_process(getpid()).c_str(), nullptr);
  const double since_boot = static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  return ticks > 0 ? std::max(0.0, since_boot - ticks / static_cast<double>(sysconf(_SC_CLK_TCK))) : 0;
}

namespace {

/// As exec(3) takes words.
std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// This process' environment, in which some variables have other values.
std::vector<std::string> environment_with(const std::map<std::string, std::string>& variables) {
  std::vector<std::string> all;
  for (char** own = environ; *own; ++own) {
    const std::string text = *own;
    if (!variables.contains(text.substr(0, text.find('=')))) all.push_back(text);
  }
  for (const auto& [name, value] : variables) all.push_back(name + "=" + value);
  return all;
}

}  // namespace

Process::Process(std::vector<std::string> words, const Streams& streams) {
  std::vector<std::string> environment = environment_with(streams.variables);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  if (streams.input) posix_spawn_file_actions_adddup2(&files, fileno(streams.input), STDIN_FILENO);
  if (!streams.output.empty()) {
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, streams.output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  }
  const std::vector<char*> arguments = pointers_to(words), variables = pointers_to(environment);
  if (posix_spawnp(&id_, arguments[0], &files, nullptr, arguments.data(), variables.data()) != 0)
    exit_code_ = not_started;
  posix_spawn_file_actions_destroy(&files);
}

void Process::take(int status) {
  exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : by_signal + WTERMSIG(status);
}

std::optional<int> Process::exit_code() {
  int status = 0;
  if (!exit_code_ && waitpid(id_, &status, WNOHANG) == id_) take(status);
  return exit_code_;
}

int Process::wait() {
  int status = 0;
  while (!exit_code_)
    if (waitpid(id_, &status, 0) == id_)
      take(status);
    else if (errno != EINTR)
      exit_code_ = not_started;
  return *exit_code_;
}

void Process::ask_to_stop() const {
  if (!exit_code_) kill(id_, SIGTERM);
}

}  // namespace sphk
