// SPDX-License-Identifier: BSD-3-Clause
#include "src/stability/remarks.hpp"

#include <fmt/format.h>

#include <numbers>

#include "kernels/smoothing/list.hpp"
#include "src/engine/geometry.hpp"
#include "src/stability/dispersion.hpp"

namespace sphk {

namespace {

constexpr int samples = 64;  // of a direction

const char* lattice_of(int dimension) {
  return dimension == 1 ? "line" : dimension == 2 ? "square" : "cubic";
}

/// The squares of the distances of all particles of the lattice within h, one by one; 0 for the one at the centre.
std::vector<double> distances2(double h, int dimension) {
  const int reach = static_cast<int>(std::ceil(h));
  const auto range = [&](int d) { return d < dimension ? reach : 0; };
  std::vector<double> all;
  for (int a = -range(0); a <= range(0); ++a)
    for (int b = -range(1); b <= range(1); ++b)
      for (int c = -range(2); c <= range(2); ++c) all.push_back(a * a + b * b + c * c);
  return all;
}

}  // namespace

std::string stability_remark(const std::string& kernel, double neighbours, int dimension, double gamma) {
  const char* lattice = lattice_of(dimension);
  const double h = lattice_support(neighbours, dimension);
  if (!(h < widest_support)) return "";
  const WaveModes least = least_waves(find_lattice(lattice), kernel, h, gamma, samples);
  if (least.least() >= unstable_below) return "";
  const bool clumps = least.longitudinal < unstable_below;
  return fmt::format(
      "particles of {} with {:g} neighbours leave a {} lattice ({}, omega^2/(k^2 c^2) = {:.2g}; R10): "
      "`sphk stability --kernel {} --lattice {}` lists stable neighbour numbers",
      kernel, neighbours, lattice, clumps ? "they clump" : "they slip past each other", least.least(), kernel, lattice);
}

double lattice_density(const KernelPair& pair, int dimension) {
  double density = 1;
  for (int round = 0; round < 100; ++round) {  // density hangs on h, and h on it, but little
    const double h = lattice_support(pair.neighbours / density, dimension);
    const double before = density;
    density = with_kernel(pair.kernel, [&](const auto& kernel) {
      double sum = 0;
      for (const double r2 : distances2(h, dimension))
        if (r2 < h * h) sum += kernel.w(std::sqrt(r2) / h);
      return kernel.norm(dimension) / std::pow(h, dimension) * sum;
    });
    density = 0.5 * (density + before);
    if (std::abs(density - before) < 1e-12) break;
  }
  return density;
}

std::string sampling_remark(const KernelPair& pair, const KernelPair& usual, int dimension) {
  if (!(lattice_support(pair.neighbours, dimension) < widest_support)) return "";
  const double error = lattice_density(pair, dimension) - 1;
  if (std::abs(error) <= 0.03) return "";
  const double better = lattice_density(usual, dimension) - 1;
  return fmt::format(
      "{} with {:g} neighbours measures the density of a {} lattice {:.1f} % too {}; {} with {:g} is {:.1f} % off "
      "(sph.kernel, sph.neighbours)",
      pair.kernel, pair.neighbours, lattice_of(dimension), 100 * std::abs(error), error > 0 ? "high" : "low",
      usual.kernel, usual.neighbours, 100 * std::abs(better));
}

double largest_courant(const KernelPair& pair, int dimension, double gamma) {
  const double h = lattice_support(pair.neighbours, dimension);
  const Dispersion dispersion(find_lattice(lattice_of(dimension)), pair.kernel, h, gamma);
  double fastest = 0;  // omega / c
  for (const WaveDirection& direction : wave_directions(dimension))
    for (int n = 1; n <= samples; ++n) {
      const double kappa = std::numbers::pi * n / samples;
      const Array3 k{kappa * direction.k[0], kappa * direction.k[1], kappa * direction.k[2]};
      const double ratio = dispersion.at(k).longitudinal;
      if (ratio > 0) fastest = std::max(fastest, std::sqrt(ratio * (k[0] * k[0] + k[1] * k[1] + k[2] * k[2])));
    }
  return 0.8 * 4 / (h * fastest);
}

std::string courant_remark(double courant, const KernelPair& pair, int dimension, double gamma) {
  if (!(lattice_support(pair.neighbours, dimension) < widest_support)) return "";
  const double largest = largest_courant(pair, dimension, gamma);
  if (courant <= largest) return "";
  return fmt::format(
      "time.courant = {:g}: above {:.2g} the shortest sound waves of {} with {:g} neighbours grow from step to step, "
      "and no result can be trusted",
      courant, largest, pair.kernel, pair.neighbours);
}

}  // namespace sphk
