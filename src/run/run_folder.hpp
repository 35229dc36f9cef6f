#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace sphk {

/// Throws InputError when `folder` holds a run already: to be asked before any work is done.
void refuse_used_folder(const std::filesystem::path& folder);

/// Creates the folder of a run. Without `asked`: ./NAME-run, or the first free one of NAME-run-2, NAME-run-3, ... With
/// `asked`: that folder, made where it is missing; when it already holds a run this throws InputError, unless
/// `overwrite`, which first removes what the previous run left (snapshots, run.json, history.csv, series, scene file,
/// figures of `sphk plot`).
std::filesystem::path make_run_folder(const std::string& name, const std::optional<std::filesystem::path>& asked,
                                      bool overwrite);

}  // namespace sphk
