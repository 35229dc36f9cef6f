#include "src/engine/output.hpp"

#include <fmt/format.h>

namespace sphk {

std::vector<std::string> warnings_of(const SupportCounts& searches, const FitCounts& fits) {
  std::vector<std::string> warnings;
  if (searches.capped > 0)
    warnings.push_back(
        fmt::format("{} searches ended at the largest support radius with fewer neighbours than asked: raise "
                    "sph.h_max or lower sph.neighbours",
                    searches.capped));
  if (searches.crowded > 0)
    warnings.push_back(
        fmt::format("{} searches found more coincident particles than neighbours asked: their support holds "
                    "nobody else; `sphk ic check` lists them",
                    searches.crowded));
  if (searches.failed > 0)
    warnings.push_back(fmt::format("{} searches for a support radius did not converge", searches.failed));
  if (fits.linear + fits.sph > 0)
    warnings.push_back(fmt::format(
        "{} fits of the velocity gradients were linear and {} gave way to the SPH estimate: too few neighbours, or on "
        "a line or plane; more of them (sph.neighbours) allow second order",
        fits.linear, fits.sph));
  return warnings;
}

}  // namespace sphk
