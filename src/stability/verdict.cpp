#include "src/stability/verdict.hpp"

#include <fmt/format.h>

namespace sphk {

WaveModes least_waves(const Lattice& lattice, const std::string& kernel, double h, double gamma, int samples) {
  const Dispersion dispersion(lattice, kernel, h, gamma);
  WaveModes least = no_waves();
  for (const WaveDirection& direction : wave_directions(lattice.dimension))
    least = slower(least, slowest_waves(dispersion, direction.k, samples));
  return least;
}

std::string stability_remark(const std::string& kernel, double neighbours, int dimension, double gamma) {
  const char* lattice = dimension == 1 ? "line" : dimension == 2 ? "square" : "cubic";
  const double h = lattice_support(neighbours, dimension);
  if (!(h < widest_support)) return "";
  const WaveModes least = least_waves(find_lattice(lattice), kernel, h, gamma, 64);
  if (least.least() >= unstable_below) return "";
  const bool clumps = least.longitudinal < unstable_below;
  return fmt::format(
      "particles of {} with {:g} neighbours leave a {} lattice ({}, omega^2/(k^2 c^2) = {:.2g}; R10): "
      "`sphk stability --kernel {} --lattice {}` lists stable neighbour numbers",
      kernel, neighbours, lattice, clumps ? "they clump" : "they slip past each other", least.least(), kernel, lattice);
}

}  // namespace sphk
