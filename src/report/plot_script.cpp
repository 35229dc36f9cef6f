#include "src/report/plot_script.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "src/engine/errors.hpp"
#include "src/engine/places.hpp"
#include "src/report/process.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

constexpr int missing_package = 86;  // the exit code of src/report/plot/plot.py

fs::path script_path() {
  const fs::path script = shared_folder() / "plot/plot.py";
  if (!fs::exists(script))
    throw InputError(fmt::format("the drawing script {} is missing: build or install sphk again", script.string()));
  return script;
}

/// A temporary file that holds the work; the script reads it as its standard input.
std::FILE* work_file(const std::string& work) {
  std::FILE* file = std::tmpfile();
  if (!file || std::fwrite(work.data(), 1, work.size(), file) != work.size() || std::fflush(file) != 0)
    throw InputError("cannot write a temporary file for the figures: is the disk full?");
  return file;
}

}  // namespace

void run_plot_script(const std::string& work) {
  const std::string script = script_path().string();
  std::vector<std::string> pythons{"/usr/bin/python3", "python3"};
  if (const char* chosen = std::getenv("SPHK_PYTHON")) pythons = {chosen};
  std::FILE* file = work_file(work);
  int code = Process::not_started;
  const auto unfit = [&] { return code == Process::not_started || code == missing_package; };
  for (const std::string& python : pythons) {
    if (!unfit()) break;
    std::fflush(stdout);
    std::rewind(file);
    code = Process({python, "-B", script}, {.input = file}).wait();
  }
  std::fclose(file);
  if (unfit())
    throw InputError(
        "figures need Python 3 with matplotlib and h5py: sudo apt-get install python3-matplotlib python3-h5py\n"
        "(another Python can be named in the environment variable SPHK_PYTHON)");
  if (code != 0) throw InputError(fmt::format("the drawing script ended with code {}; its message is above", code));
}

}  // namespace sphk
