#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sphk {

struct ExtremesRequest {
  std::optional<std::filesystem::path> out;  ///< nothing: "extremes"
  std::vector<std::string> cases;            ///< names, or files (*.toml); without names: all
  int threads = 0;                           ///< of each run; 0: what OpenMP gives
};

/// Runs the cases, each a process of its own, and tells on standard output and in the folder's extremes.txt what is
/// required of each and what came out. Returns whether all kept within their bounds; a signal stops it
/// (stop_signal.hpp), without a table. Throws InputError, before anything runs, for cases that are none.
bool make_extremes(const ExtremesRequest& request);

}  // namespace sphk
