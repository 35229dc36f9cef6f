#include "src/stability/verdict.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace sphk {

double LeastWaves::least() const {
  return std::fmin(std::fmin(longitudinal, transverse), relative);
}

LeastWaves least_waves(const Lattice& lattice, const std::string& kernel, double h, double gamma, int samples) {
  const Dispersion dispersion(lattice, kernel, h, gamma);
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  LeastWaves least{{nothing, nothing, nothing}};
  for (const WaveDirection& direction : wave_directions(lattice.dimension)) {
    const WaveModes slowest = slowest_waves(dispersion, direction.k, samples);
    least.longitudinal = std::fmin(least.longitudinal, slowest.longitudinal);
    least.transverse = std::fmin(least.transverse, slowest.transverse);
    least.relative = std::fmin(least.relative, slowest.relative);
  }
  return least;
}

std::string stability_remark(const std::string& kernel, double neighbours, int dimension, double gamma) {
  const char* lattice = dimension == 1 ? "line" : dimension == 2 ? "square" : "cubic";
  const LeastWaves least =
      least_waves(find_lattice(lattice), kernel, lattice_support(neighbours, dimension), gamma, 64);
  if (least.least() >= unstable_below) return "";
  const bool clumps = least.longitudinal < unstable_below;
  return fmt::format(
      "particles of {} with {:g} neighbours leave a {} lattice ({}, omega^2/(k^2 c^2) = {:.2g}; R10): "
      "`sphk stability --kernel {} --lattice {}` lists stable neighbour numbers",
      kernel, neighbours, lattice, clumps ? "they clump" : "they slip past each other", least.least(), kernel, lattice);
}

}  // namespace sphk
