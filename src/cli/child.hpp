#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace sphk {

/// Runs this executable with these arguments, its output in `log`, and returns its exit code, or 128 and the number of
/// the signal that ended it. `watch` is called about twice a second meanwhile. A request to stop (stop_signal.hpp) is
/// passed on. Throws InputError where it cannot be started.
int run_child(const std::vector<std::string>& arguments, const std::filesystem::path& log,
              const std::function<void()>& watch = {});

/// Why a child failed: what its log says, or the signal that ended it.
std::string reason_of(int code, const std::filesystem::path& log);

/// The last JSON object in the log of a `sphk run --json-log` that tells how far it is: share of the run that is done.
double share_done(const std::filesystem::path& log);

}  // namespace sphk
