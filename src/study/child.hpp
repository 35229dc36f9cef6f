#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace sphk {

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
