// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "src/engine/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/run/watch.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

/// What tells that a run is complete, or that it can go on.
constexpr const char* verdict_files[] = {"run.json", "checkpoint_a.hdf5", "checkpoint_b.hdf5"};

/// Does a run leave a file of this name?
bool is_run_file(const std::string& name) {
  if (std::ranges::find(verdict_files, name) != std::end(verdict_files)) return true;
  if (std::ranges::find(watch_pictures, name) != watch_pictures.end()) return true;
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

/// What killed processes left of files that they had not yet named; the folder belongs to this process.
void remove_temporaries(const fs::path& folder) {
  std::vector<fs::path> left;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const auto name = name_of_temporary(entry.path().filename().string());
    if (name && (is_run_file(*name) || *name == FolderLock::file_name)) left.push_back(entry.path());
  }
  for (const fs::path& file : left) fs::remove(file);
}

/// Would the run lose the file that it comes from? That may be one of several parts, which lie beside it.
bool is_source_in(const fs::path& folder, const fs::path& source) {
  std::error_code none;
  const auto lies_in = [&](const fs::path& file) {
    return is_run_file(file.filename().string()) && fs::equivalent(file.parent_path(), folder, none);
  };
  return !source.empty() && (lies_in(fs::absolute(source)) || lies_in(fs::weakly_canonical(source, none)));
}

void refuse_lost_files(const FolderRequest& request) {
  const fs::path& folder = *request.asked;
  if (!fs::is_directory(folder)) return;
  if (!request.overwrite && !run_files(folder).empty())
    throw InputError(fmt::format(
        "{} already holds a run; name another folder with --out, or add --overwrite to replace it", folder.string()));
  if (is_source_in(folder, request.source))
    throw InputError(
        fmt::format("--overwrite would remove {}, which the run is to start from; name another folder "
                    "with --out",
                    request.source.string()));
}

RunFolder make_free_folder(const std::string& name) {
  for (int number = 1;; ++number) {
    const fs::path folder = number == 1 ? name + "-run" : fmt::format("{}-run-{}", name, number);
    if (!fs::exists(folder) && fs::create_directory(folder)) return take_run_folder(folder);
  }
}

RunFolder make_asked_folder(const FolderRequest& request) {
  const fs::path& folder = *request.asked;
  fs::create_directories(folder);
  RunFolder taken = take_run_folder(folder);
  refuse_lost_files(request);
  for (const char* name : verdict_files) fs::remove(folder / name);  // first: half a run must not pass for a whole one
  for (const fs::path& file : run_files(folder)) fs::remove(file);
  return taken;
}

}  // namespace

void refuse_used_folder(const FolderRequest& request) {
  if (!request.asked) return;
  FolderLock::refuse_locked(*request.asked);
  refuse_lost_files(request);
}

RunFolder take_run_folder(const fs::path& folder) {
  RunFolder taken{folder, FolderLock(folder)};
  remove_temporaries(folder);
  return taken;
}

RunFolder make_run_folder(const std::string& name, const FolderRequest& request) {
  try {
    return request.asked ? make_asked_folder(request) : make_free_folder(name);
  } catch (const fs::filesystem_error& error) {
    throw InputError(fmt::format("cannot make the run's folder: {}; choose another place with --out", error.what()));
  }
}

}  // namespace sphk
