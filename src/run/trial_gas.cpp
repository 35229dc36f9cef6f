// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/trial_gas.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "src/report/machine.hpp"
#include "src/report/quantity.hpp"
#include "src/run/problem.hpp"
#include "src/schemes/registry.hpp"
#include "src/schemes/resolve.hpp"

namespace sphk {

namespace {

/// More than these are not asked for. Cells, threads and caches of a run are all in use with as many.
constexpr double most = 2e5;

ParticleSet gas_of(const Scene& scene, Settings settings, std::int64_t n) {
  settings.set("scene.n", n, Origin::scene);
  return scene.build(settings);
}

/// Whether all particles are so few that no machine lacks the memory for them.
bool is_small(const Scene& scene, const Settings& settings) {
  return !settings.has("scene.n") ||
         std::pow(static_cast<double>(settings.integer("scene.n")), scene.dimension(settings)) < 10 * most;
}

}  // namespace

ParticleSet thinned(const ParticleSet& gas, std::size_t k) {
  ParticleSet few{.dimension = gas.dimension, .box = gas.box, .time = gas.time};
  const auto keep = [](const auto& from, auto& to, std::size_t i) {
    if (!from.empty()) to.push_back(from[i]);
  };
  std::uint64_t random = 1;  // not always the same of the k: rows of a lattice would lose whole planes
  for (std::size_t first = 0; first + k <= gas.size(); first += k) {
    random = random * 6364136223846793005u + 1442695040888963407u;  // Knuth's MMIX generator
    const std::size_t i = first + (random >> 33) % k;
    few.x.push_back(gas.x[i]);
    few.v.push_back(gas.v[i]);
    few.m.push_back(static_cast<double>(k) * gas.m[i]);
    few.u.push_back(gas.u[i]);
    keep(gas.alpha, few.alpha, i);
    keep(gas.id, few.id, i);
    keep(gas.tag, few.tag, i);
  }
  return few;
}

TrialGas trial_gas(const Scene& scene, const Settings& settings) {
  const int D = scene.dimension(settings);
  if (!settings.has("scene.n")) {
    ParticleSet all = scene.build(settings);
    const auto particles = static_cast<double>(all.size());
    const double k = std::ceil(particles / most);
    if (k <= 1) return {std::move(all), particles, 1};
    return {thinned(all, static_cast<std::size_t>(k)), particles, std::pow(k, 1.0 / D)};
  }
  const std::int64_t n = settings.integer("scene.n");
  int halvings = 0;
  while (std::pow(static_cast<double>(n >> halvings), D) > most) ++halvings;
  ParticleSet gas = gas_of(scene, settings, n >> halvings);
  auto particles = static_cast<double>(gas.size());
  if (halvings == 0) return {std::move(gas), particles, 1};
  const std::int64_t fine = n >> halvings, coarse = fine / 2;
  const double coarser = static_cast<double>(gas_of(scene, settings, coarse).size());
  const double refinement = static_cast<double>(n) / static_cast<double>(fine);
  const double dimensions =
      std::log(particles / coarser) / std::log(static_cast<double>(fine) / static_cast<double>(coarse));
  particles *= std::pow(refinement, dimensions);
  return {std::move(gas), std::round(particles), refinement};
}

void require_memory(const Scene& scene, const Settings& settings) {
  if (is_small(scene, settings)) return;
  const TrialGas trial = trial_gas(scene, with_lattice(settings));
  require_memory(trial.particles, describe(simulation_settings(settings), trial.gas).bytes_per_particle);
}

void require_memory(double particles, double bytes_per_particle) {
  const double needed = particles * bytes_per_particle, available = available_memory_bytes();
  if (needed > available)
    throw std::runtime_error(fmt::format(
        "{:.3g} particles of {:.0f} bytes would take {}, more than the {} of memory that are free here: take "
        "fewer particles (-n), or ask `sphk run ... --dry-run` what is needed",
        particles, bytes_per_particle, bytes_text(needed), bytes_text(available)));
}

}  // namespace sphk
