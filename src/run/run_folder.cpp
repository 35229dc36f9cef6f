#include "src/run/run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "src/engine/errors.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

/// What tells that a run is complete, or that it can go on.
constexpr const char* verdict_files[] = {"run.json", "checkpoint_a.hdf5", "checkpoint_b.hdf5"};

/// Does a run leave a file of this name?
bool is_run_file(const std::string& name) {
  if (std::ranges::find(verdict_files, name) != std::end(verdict_files)) return true;
  for (const char* fixed : {"scene.used.toml", "history.csv", "run.hdf.series", "stop"})
    if (name == fixed) return true;
  return (name.starts_with("snap_") && (name.ends_with(".hdf5") || name.ends_with(".png"))) || name == "history.png";
}

std::vector<fs::path> run_files(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (is_run_file(entry.path().filename().string())) files.push_back(entry.path());
  return files;
}

fs::path make_free_folder(const std::string& name) {
  for (int number = 1;; ++number) {
    const fs::path folder = number == 1 ? name + "-run" : fmt::format("{}-run-{}", name, number);
    if (!fs::exists(folder) && fs::create_directory(folder)) return folder;
  }
}

fs::path make_asked_folder(const fs::path& folder, bool overwrite) {
  fs::create_directories(folder);
  if (!overwrite) refuse_used_folder(folder);
  for (const char* name : verdict_files) fs::remove(folder / name);  // first: half a run must not pass for a whole one
  for (const fs::path& file : run_files(folder)) fs::remove(file);
  return folder;
}

}  // namespace

void refuse_used_folder(const fs::path& folder) {
  if (fs::is_directory(folder) && !run_files(folder).empty())
    throw InputError(fmt::format(
        "{} already holds a run; name another folder with --out, or add --overwrite to replace it", folder.string()));
}

fs::path make_run_folder(const std::string& name, const std::optional<fs::path>& asked, bool overwrite) {
  try {
    return asked ? make_asked_folder(*asked, overwrite) : make_free_folder(name);
  } catch (const fs::filesystem_error& error) {
    throw InputError(fmt::format("cannot make the run's folder: {}; choose another place with --out", error.what()));
  }
}

}  // namespace sphk
