// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/plot_script.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

#include "src/engine/errors.hpp"
#include "src/engine/places.hpp"
#include "src/report/process.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

constexpr int missing_package = 86;  // the exit code of src/python/sphk/figures/__main__.py

/// The folder of the Python package, before those that the user's Python looks in.
std::string python_path() {
  const fs::path folder = shared_folder() / "python";
  if (!fs::exists(folder / "sphk/figures"))
    throw InputError(
        fmt::format("the drawing scripts in {} are missing: build or install sphk again", folder.string()));
  const char* users = std::getenv("PYTHONPATH");
  return folder.string() + (users ? std::string(":") + users : "");
}

/// A temporary file that holds the work; the scripts read it as their standard input.
std::FILE* work_file(const std::string& work) {
  std::FILE* file = std::tmpfile();
  if (!file || std::fwrite(work.data(), 1, work.size(), file) != work.size() || std::fflush(file) != 0)
    throw InputError("cannot write a temporary file for the figures: is the disk full?");
  return file;
}

}  // namespace

void run_plot_script(const std::string& work, const std::vector<std::string>& packages) {
  const std::string path = python_path();
  std::vector<std::string> pythons{"/usr/bin/python3", "python3"};
  if (const char* chosen = std::getenv("SPHK_PYTHON")) pythons = {chosen};
  std::FILE* file = work_file(work);
  int code = Process::not_started;
  const auto unfit = [&] { return code == Process::not_started || code == missing_package; };
  for (const std::string& python : pythons) {
    if (!unfit()) break;
    std::fflush(stdout);
    std::rewind(file);
    std::vector<std::string> words{python, "-B", "-m", "sphk.figures"};
    words.insert(words.end(), packages.begin(), packages.end());
    code = Process(words, {.input = file, .variables = {{"PYTHONPATH", path}}}).wait();
  }
  std::fclose(file);
  if (unfit())
    throw InputError(fmt::format(
        "figures and pages need Python 3 with {}: sudo apt-get install python3-{}\n(or name another Python, with "
        "these from pip, in the environment variable SPHK_PYTHON)",
        fmt::join(packages, " and "), fmt::join(packages, " python3-")));
  if (code != 0) throw InputError(fmt::format("the drawing script ended with code {}; its message is above", code));
}

}  // namespace sphk
