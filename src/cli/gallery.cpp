#include "src/study/gallery.hpp"
#include "src/cli/commands.hpp"
#include "src/run/stop_signal.hpp"

namespace sphk {

int gallery_command(const GalleryRequest& request) {
  const bool complete = make_gallery(request);
  if (stop_requested()) return ExitCode::stopped;
  return complete ? ExitCode::done : ExitCode::numerics;
}

}  // namespace sphk
