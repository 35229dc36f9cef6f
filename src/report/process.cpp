#include "src/report/process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

extern char** environ;

namespace sphk {

namespace fs = std::filesystem;

fs::path this_executable() {
  return fs::read_symlink("/proc/self/exe");
}

fs::path shared_folder() {
  return this_executable().parent_path().parent_path() / "share/sphk";
}

Process::Process(std::vector<std::string> words, const Streams& streams) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  if (streams.input) posix_spawn_file_actions_adddup2(&files, fileno(streams.input), STDIN_FILENO);
  if (!streams.output.empty()) {
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, streams.output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  }
  if (posix_spawnp(&id_, pointers[0], &files, nullptr, pointers.data(), environ) != 0) exit_code_ = not_started;
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
