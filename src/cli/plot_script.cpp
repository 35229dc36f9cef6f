#include "src/cli/plot_script.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "src/cli/platform.hpp"
#include "src/engine/errors.hpp"

extern char** environ;

namespace sphk {

namespace fs = std::filesystem;

namespace {

/// The script's exit code when a Python package is missing (src/report/plot/plot.py); 127 is the shell's "not found".
constexpr int missing_package = 86, not_found = 127;

fs::path script_path() {
  const fs::path script = shared_folder() / "plot/plot.py";
  if (!fs::exists(script))
    throw InputError(fmt::format("the drawing script {} is missing: build or install sphk again", script.string()));
  return script;
}

/// A temporary file that holds the work, rewound; the script reads it as its standard input.
std::FILE* work_file(const std::string& work) {
  std::FILE* file = std::tmpfile();
  if (!file || std::fwrite(work.data(), 1, work.size(), file) != work.size() || std::fflush(file) != 0)
    throw InputError("cannot write a temporary file for the figures: is the disk full?");
  std::rewind(file);
  return file;
}

/// Exit code of `python script < work`.
int run_with(const std::string& python, const std::string& script, std::FILE* work) {
  std::rewind(work);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, fileno(work), STDIN_FILENO);
  std::vector<std::string> words{python, "-B", script};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int error = posix_spawnp(&child, python.c_str(), &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0) return not_found;
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

}  // namespace

void run_plot_script(const std::string& work) {
  const std::string script = script_path().string();
  std::vector<std::string> pythons{"/usr/bin/python3", "python3"};
  if (const char* chosen = std::getenv("SPHK_PYTHON")) pythons = {chosen};
  std::FILE* file = work_file(work);
  int code = not_found;
  for (const std::string& python : pythons) {
    std::fflush(stdout);
    code = run_with(python, script, file);
    if (code != not_found && code != missing_package) break;
  }
  std::fclose(file);
  if (code == not_found || code == missing_package)
    throw InputError(
        "figures need Python 3 with matplotlib and h5py: sudo apt-get install python3-matplotlib python3-h5py\n"
        "(another Python can be named in the environment variable SPHK_PYTHON)");
  if (code != 0) throw InputError(fmt::format("the drawing script ended with code {}; its message is above", code));
}

}  // namespace sphk
