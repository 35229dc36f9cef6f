// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "src/run/problem.hpp"

namespace sphk {

/// Many runs, each a process of its own.
struct Batch {
  std::optional<std::filesystem::path> out;  ///< the folder of all; nothing: called like the command
  std::vector<std::string> names;            ///< of those that are wanted; empty: all
  int threads = 0;                           ///< of each run; 0: what OpenMP gives

  bool wants(const std::string& name) const { return names.empty() || std::ranges::find(names, name) != names.end(); }
};

/// `what` with these keys, the later of equal ones, in a folder that it may overwrite, as run_child takes it.
std::vector<std::string> run_arguments(const std::string& what, const KeyTexts& keys,
                                       const std::filesystem::path& folder, int threads);

/// `sphk run ARGUMENTS --json-log` as a process of its own, its output in `log`. Returns its exit code, or 128 and the
/// number of the signal that ended it. `watch` is called about twice a second meanwhile. A request to stop
/// (stop_signal.hpp) is passed on. Throws InputError where it cannot be started.
int run_child(const std::vector<std::string>& arguments, const std::filesystem::path& log,
              const std::function<void()>& watch = {});

/// The last line of a child's log that is a JSON object with this key; null where there is none.
nlohmann::json last_with(const std::string& key, const std::filesystem::path& log);

/// Why a child failed: the error in its log, or the signal that ended it.
std::string reason_of(int code, const std::filesystem::path& log);

/// How far it is by its log: share of the run that is done.
double share_done(const std::filesystem::path& log);

}  // namespace sphk
