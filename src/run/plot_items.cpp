#include "src/run/plot_items.hpp"

#include <fmt/format.h>

#include <cmath>

#include "src/io/reader.hpp"
#include "src/run/file_scene.hpp"
#include "src/run/plot_fields.hpp"
#include "src/schemes/registry.hpp"

namespace sphk {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;

namespace {

/// Where the hint's centre is at a time, in the box.
Array3 centre_at(const PlotHint& hint, const ParticleSet& particles) {
  Array3 centre = hint.centre;
  for (int axis = 0; axis < particles.dimension; ++axis) {
    const double lower = particles.box.lower[axis], size = particles.box.size[axis];
    centre[axis] += hint.velocity[axis] * particles.time;
    if (particles.box.periodic[axis]) centre[axis] -= size * std::floor((centre[axis] - lower) / size);
  }
  return centre;
}

/// What `v` is along the scene's abscissa: v_x along x and y, the azimuthal velocity along R and the radial one along
/// r.
const char* shown_velocity(const std::string& abscissa) {
  return abscissa == "R" ? "phi" : abscissa == "r" ? "r" : "x";
}

/// The exact solution sampled along the scene's abscissa from the centre. Velocities about a centre are beside its own.
Json exact_profile(const Problem& problem, const PlotHint& hint, const Array3& centre, double time) {
  const auto exact = problem.scene->exact(problem.settings);
  if (!exact) return nullptr;
  constexpr int points = 4000;
  const double gamma = problem.settings.real("sph.gamma");
  const bool from_centre = hint.abscissa == "R" || hint.abscissa == "r";
  const Array3 beside = from_centre ? hint.velocity : Array3{};
  const int axis = hint.abscissa == "y" ? 1 : 0;
  const std::string along = hint.abscissa == "R"   ? "v_R"
                            : hint.abscissa == "r" ? "v_r"
                                                   : "v_x",
                    across = hint.abscissa == "R" ? "v_phi" : "v_y";
  Json profile;
  for (int k = 0; k < points; ++k) {
    const double s = hint.from + (k + 0.5) / points * (hint.to - hint.from);
    Array3 place = centre;
    place[axis] = from_centre ? centre[axis] + s : s;
    const GasState state = exact(place, time);
    profile["abscissa"].push_back(s);
    profile["rho"].push_back(state.rho);
    profile["P"].push_back(state.P);
    profile[along].push_back(state.v[0] - beside[0]);
    if (hint.abscissa != "r") profile[across].push_back(state.v[1] - beside[1]);
    profile["u"].push_back(state.u(gamma));
    profile["A"].push_back(state.P / std::pow(state.rho, gamma));
  }
  profile["v"] = profile[std::string("v_") + shown_velocity(hint.abscissa)];
  return profile;
}

/// What the axes say beside the names; null: code units.
Json unit_labels(const ReadResult& content) {
  if (!content.units) return nullptr;
  Json labels;
  for (const char* quantity : {"x", "t", "v", "m", "rho", "P", "u", "A", "energy"})
    labels[quantity] =
        unit_label(*content.units, quantity, content.particles.dimension, content.gamma.value_or(5.0 / 3));
  return labels;
}

/// By name, dataset and part of all fields that figures can show.
Json names_of(const fs::path& snapshot, const std::string& abscissa, int dimension) {
  Json names = Json::object();
  for (const PlotField& field : plot_fields(snapshot, dimension)) names[field.name] = {field.dataset, field.part};
  if (names.contains("v")) names["v"][1] = shown_velocity(abscissa);
  return names;
}

}  // namespace

Json describe_snapshot(const fs::path& snapshot, const std::optional<Problem>& problem, bool exact) {
  const ReadResult content = read_particles(snapshot);
  const ParticleSet& particles = content.particles;
  const Box& box = particles.box;
  const PlotHint hint = problem ? problem->scene->plot_hint(problem->settings) : plain_hint(box);
  const Array3 centre = centre_at(hint, particles);
  const Json names = names_of(snapshot, hint.abscissa, particles.dimension);
  std::vector<std::string> fields = hint.fields;
  for (const char* extra : {"alpha", "E0"})  // S12 Figs. 3, 5
    if (names.contains(extra)) fields.emplace_back(extra);
  Json json = {{"file", snapshot.string()},
               {"time", particles.time},
               {"dimension", particles.dimension},
               {"box_lower", box.lower},
               {"box_size", box.size},
               {"periodic", box.periodic},
               {"abscissa", hint.abscissa},
               {"fields", fields},
               {"names", names},
               {"from", hint.from},
               {"to", hint.to},
               {"centre", centre},
               {"velocity", hint.velocity},
               {"map", hint.map},
               {"units", unit_labels(content)},
               {"exact", nullptr},
               {"title", snapshot.stem().string()}};
  if (!problem) return json;
  const SimulationSettings s = simulation_settings(problem->settings);
  json["title"] = fmt::format("{}, {} {} {:g}, {} particles", problem->scene->name(), s.scheme, s.kernel, s.neighbours,
                              particles.size());
  if (exact) json["exact"] = exact_profile(*problem, hint, centre, particles.time);
  return json;
}

}  // namespace sphk
