#include "src/run/plot.hpp"

#include "src/cli/commands.hpp"

namespace sphk {

int plot_command(const PlotRequest& request) {
  plot(request);
  return ExitCode::done;
}

}  // namespace sphk
