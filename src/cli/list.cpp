// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "src/cli/commands.hpp"
#include "src/cli/options.hpp"
#include "src/engine/errors.hpp"
#include "src/run/dry_run.hpp"
#include "src/schemes/registry.hpp"

namespace sphk {

namespace {

std::string rough_text(double seconds) {
  if (seconds < 60) return fmt::format("{:.0f} s", std::max(1.0, seconds));
  return seconds < 3600 ? fmt::format("{:.0f} min", seconds / 60) : fmt::format("{:.1f} h", seconds / 3600);
}

/// "cs 5, cs 20, cs 48": the pairs of a scheme in 1D, 2D and 3D; - where it has none.
std::string usual_pairs(const SchemeFacts& scheme) {
  std::vector<std::string> pairs;
  for (const KernelChoice& pair : scheme.usual)
    pairs.push_back(pair.kernel ? fmt::format("{} {:g}", pair.kernel, pair.neighbours) : "-");
  return fmt::format("{}", fmt::join(pairs, ", "));
}

void print_schemes() {
  fmt::print("\n{:<18} {:<28} {}\n", "scheme", "usual kernel in 1D, 2D, 3D", "what it is");
  for (const std::string& name : scheme_names()) {
    const SchemeFacts& scheme = *scheme_entry(name).facts;
    fmt::print("{:<18} {:<28} {}\n", name, usual_pairs(scheme), scheme.summary);
  }
}

/// Particles and rough cost of a scene's defaults; what is wrong with them where they cannot be run, as in a build
/// without the scene's usual scheme.
void print_scene(const Scene& scene) {
  constexpr const char* row = "{:<15} {:>10} {:>9}  {}\n";
  try {
    const Settings settings = with_lattice(resolve_problem(scene.name(), {}).settings);
    const ParticleSet particles = scene.build(settings);
    fmt::print(row, scene.name(), particles.size(), fmt::format("~{}", rough_text(rough_seconds(particles, settings))),
               scene.summary());
  } catch (const InputError& error) {
    fmt::print(row, scene.name(), "-", "-", fmt::format("{}; its defaults: {}", scene.summary(), error.what()));
  }
}

int list_command() {
  fmt::print("{:<15} {:>10} {:>9}  {}\n", "scene", "particles", "cost", "what it is");
  for (const Scene* scene : scenes()) print_scene(*scene);
  print_schemes();
  fmt::print(
      "\nParticles and a rough cost on this machine's cores are those of the defaults; `sphk run SCENE --dry-run` "
      "measures.\n`sphk show SCENE` tells what a scene computes and its keys.\n");
  return ExitCode::done;
}

}  // namespace

void add_list(CLI::App& root, Options& o) {
  computes(*root.add_subcommand("list", "the scenes, with their size and rough cost"), o, list_command);
}

}  // namespace sphk
