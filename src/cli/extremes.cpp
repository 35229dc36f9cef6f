#include "src/cli/commands.hpp"
#include "src/run/stop_signal.hpp"
#include "src/study/extreme_table.hpp"

namespace sphk {

int extremes_command(const ExtremesRequest& request) {
  const bool all_pass = make_extremes(request);
  if (stop_requested()) return ExitCode::stopped;
  return all_pass ? ExitCode::done : ExitCode::numerics;
}

}  // namespace sphk
