#include "src/cli/plot_items.hpp"

#include <fmt/format.h>

#include <cmath>

#include "src/cli/file_scene.hpp"
#include "src/io/reader.hpp"
#include "src/schemes/registry.hpp"

namespace sphk {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;

namespace {

/// The exact solution sampled along the scene's abscissa from the hint's centre. `v` is v_x along x, the azimuthal
/// velocity along R and the radial one along r.
Json exact_profile(const Problem& problem, const PlotHint& hint, double time) {
  const auto exact = problem.scene->exact(problem.settings);
  if (!exact) return nullptr;
  constexpr int points = 4000;
  const double gamma = problem.settings.real("sph.gamma");
  const bool from_centre = hint.abscissa == "R" || hint.abscissa == "r";
  Json profile;
  for (int k = 0; k < points; ++k) {
    const double s = hint.from + (k + 0.5) / points * (hint.to - hint.from);
    const GasState state = exact({from_centre ? hint.centre[0] + s : s, hint.centre[1], hint.centre[2]}, time);
    profile["abscissa"].push_back(s);
    profile["rho"].push_back(state.rho);
    profile["P"].push_back(state.P);
    profile["v"].push_back(state.v[hint.abscissa == "R" ? 1 : 0]);
    profile["u"].push_back(state.P / ((gamma - 1) * state.rho));
    profile["A"].push_back(state.P / std::pow(state.rho, gamma));
  }
  return profile;
}

}  // namespace

Json describe_snapshot(const fs::path& snapshot, const std::optional<Problem>& problem, bool exact) {
  const ParticleSet particles = read_particles(snapshot).particles;
  const Box& box = particles.box;
  const PlotHint hint = problem ? problem->scene->plot_hint(problem->settings) : plain_hint(box);
  Json json = {{"file", snapshot.string()},
               {"time", particles.time},
               {"dimension", particles.dimension},
               {"box_lower", box.lower},
               {"box_size", box.size},
               {"periodic", box.periodic},
               {"abscissa", hint.abscissa},
               {"fields", hint.fields},
               {"from", hint.from},
               {"to", hint.to},
               {"centre", hint.centre},
               {"map", hint.map},
               {"exact", nullptr},
               {"title", snapshot.stem().string()}};
  if (!problem) return json;
  const SimulationSettings s = simulation_settings(problem->settings);
  json["title"] = fmt::format("{}, {} {} {:g}, {} particles", problem->scene->name(), s.scheme, s.kernel, s.neighbours,
                              particles.size());
  if (exact) json["exact"] = exact_profile(*problem, hint, particles.time);
  return json;
}

}  // namespace sphk
