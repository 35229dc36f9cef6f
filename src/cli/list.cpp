#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "src/cli/commands.hpp"
#include "src/report/quantity.hpp"
#include "src/schemes/registry.hpp"

namespace sphk {

namespace {

/// Seconds of a run to its end on all cores of this machine, from numbers of particles, steps and neighbours alone: 10
/// ns per neighbour and 1.5 us per update beside them, as on a core with AVX2. Good to a factor of a few.
double rough_seconds(const ParticleSet& particles, const Settings& settings) {
  const SimulationSettings s = simulation_settings(settings);
  const double n = static_cast<double>(particles.size());
  double volume = 1, mean = 0, largest = 0;
  for (int axis = 0; axis < particles.dimension; ++axis) volume *= particles.box.size[static_cast<std::size_t>(axis)];
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Array3& v = particles.v[i];
    const double sound2 = s.gamma * (s.gamma - 1) * particles.u[i];
    const double signal = std::sqrt(sound2 + v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    mean += signal / n;
    largest = std::max(largest, signal);
  }
  // One step for all follows the fastest particle, which slows down while its energy spreads: hence between the two.
  const double signal = std::sqrt(mean * largest);
  const double spacing = std::pow(volume / n, 1.0 / particles.dimension);
  const double dt = s.courant * spacing / std::max(2 * signal, 1e-300);
  const double steps = std::max(1.0, settings.real("time.end") / dt);
  return n * steps * (1.5e-6 + 1e-8 * s.neighbours) / std::max(1u, std::thread::hardware_concurrency());
}

std::string rough_text(double seconds) {
  if (seconds < 60) return fmt::format("{:.0f} s", std::max(1.0, seconds));
  return seconds < 3600 ? fmt::format("{:.0f} min", seconds / 60) : fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace

int list_command() {
  fmt::print("{:<15} {:>10} {:>9}  {}\n", "scene", "particles", "cost", "what it is");
  for (const Scene* scene : scenes()) {
    const Problem problem = resolve_problem(scene->name(), {});
    const Settings settings = with_lattice(problem.settings);
    const ParticleSet particles = scene->build(settings);
    fmt::print("{:<15} {:>10} {:>9}  {}\n", scene->name(), particles.size(),
               "~" + rough_text(rough_seconds(particles, settings)), scene->summary());
  }
  fmt::print(
      "\nParticles and a rough cost on this machine's cores are those of the defaults; `sphk run SCENE --dry-run` "
      "measures.\n`sphk show SCENE` tells what a scene computes and its keys.\n");
  return ExitCode::done;
}

}  // namespace sphk
