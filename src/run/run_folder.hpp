// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "src/run/folder_lock.hpp"

namespace sphk {

/// The folder of a run, which belongs to this process alone for as long as this lives.
struct RunFolder {
  std::filesystem::path path;
  FolderLock lock;
};

/// What a run is asked to do with its folder.
struct FolderRequest {
  std::optional<std::filesystem::path> asked;  ///< nothing: ./NAME-run, or the first free one of NAME-run-2, ...
  bool overwrite = false;                      ///< what a previous run left there
  std::filesystem::path source{};              ///< the initial condition that the run comes from, if that is a file
};

/// Throws InputError where the folder that is asked for belongs to a process, holds a run that may not be replaced, or
/// the run's source among the files that would be: to be asked before any work is done.
void refuse_used_folder(const FolderRequest& request);

/// Makes the folder of a run, with those above it, and takes it. One that is to be overwritten loses what the previous
/// run left: snapshots, checkpoints, run.json, history.csv, series, scene file, figures of `sphk plot`. Throws
/// InputError as refuse_used_folder does.
RunFolder make_run_folder(const std::string& name, const FolderRequest& request);

/// Takes the folder of a run that goes on.
RunFolder take_run_folder(const std::filesystem::path& folder);

}  // namespace sphk
