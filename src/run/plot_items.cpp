// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/plot_items.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/report/projection.hpp"
#include "src/run/file_scene.hpp"
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

/// Fields by name; of v the part that is shown along the abscissa.
std::map<std::string, PlotField> fields_of(const fs::path& snapshot, const std::string& abscissa, int dimension) {
  std::map<std::string, PlotField> fields;
  for (const PlotField& field : plot_fields(snapshot, dimension)) fields[field.name] = field;
  if (fields.contains("v")) fields["v"].part = shown_velocity(abscissa);
  return fields;
}

/// Columns and rows of pixels.
std::array<int, 2> pixels_of(const std::array<double, 2>& size, int longer) {
  const double pixel = std::max(size[0], size[1]) / longer;
  const auto count = [&](double length) { return std::max(1, static_cast<int>(std::lround(length / pixel))); };
  return {count(size[0]), count(size[1])};
}

}  // namespace

PlotItem::PlotItem(const fs::path& snapshot, const std::optional<Problem>& problem, NumberFiles& files)
    : snapshot_(snapshot),
      content_(read_particles(snapshot)),
      hint_(problem ? problem->scene->plot_hint(problem->settings) : plain_hint(content_.particles.box)),
      centre_(centre_at(hint_, content_.particles)),
      fields_(fields_of(snapshot, hint_.abscissa, content_.particles.dimension)),
      files_(files) {
  json = {{"file", snapshot.string()}, {"time", content_.particles.time},
          {"dimension", dimension()},  {"abscissa", hint_.abscissa},
          {"from", hint_.from},        {"to", hint_.to},
          {"parts", Json::object()},   {"units", unit_labels(content_)},
          {"exact", nullptr},          {"title", snapshot.stem().string()},
          {"numbers", Json::object()}, {"images", Json::object()}};
  if (!problem) return;
  const SimulationSettings s = simulation_settings(problem->settings);
  json["title"] = fmt::format("{}, {} {} {:g}, {} particles", problem->scene->name(), s.scheme, s.kernel, s.neighbours,
                              content_.particles.size());
}

const PlotField& PlotItem::field(const std::string& name) const {
  if (!has(name)) refuse_plot_field(plot_fields(snapshot_, dimension()), name, snapshot_);
  return fields_.at(name);
}

std::vector<double> PlotItem::values(const std::string& name) const {
  return field_values(field(name), snapshot_, content_.particles, {centre_, hint_.velocity});
}

bool PlotItem::suits_map() const {
  const bool about_centre = hint_.abscissa == "R" || hint_.abscissa == "r";
  return dimension() == 2 || (dimension() == 3 && (hint_.map || about_centre));
}

std::vector<std::string> PlotItem::own_fields() const {
  std::vector<std::string> names = hint_.fields;
  names.insert(names.end(), {"alpha", "E0"});  // S12 Figs. 3, 5
  std::erase_if(names, [&](const std::string& name) { return !has(name); });
  return names;
}

std::array<double, 4> PlotItem::extent() const {
  const ParticleSet& gas = content_.particles;
  std::array<double, 4> all{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    double low = gas.box.lower[axis], high = low + gas.box.size[axis];
    if (!gas.box.periodic[axis] && gas.size() > 0) {
      const auto along = [axis](const Array3& x) { return x[axis]; };
      low = std::ranges::min(gas.x, {}, along)[axis], high = std::ranges::max(gas.x, {}, along)[axis];
      const double margin = 0.04 * std::max(high - low, 1e-6 * gas.box.size[axis]);
      low -= margin, high += margin;
    }
    all[2 * axis] = low, all[2 * axis + 1] = high;
  }
  return all;
}

void PlotItem::add_exact(const Problem& problem) {
  json["exact"] = exact_profile(problem, hint_, centre_, content_.particles.time);
}

std::vector<double> PlotItem::abscissa() const {
  const ParticleSet& gas = content_.particles;
  std::vector<double> s;
  const std::string axes = "xyz";
  if (const auto axis = axes.find(hint_.abscissa); axis != std::string::npos) {
    for (const Array3& x : gas.x) s.push_back(x[axis]);
    return s;
  }
  for (const Array3& x : gas.x) {
    const Array3 d = offset(x, centre_, gas);
    s.push_back(std::hypot(d[0], d[1], hint_.abscissa == "R" ? 0 : d[2]));
  }
  return s;
}

void PlotItem::add_along(const std::vector<std::string>& names) {
  json["numbers"]["abscissa"] = files_.add(abscissa());
  for (const std::string& name : names) {
    add_numbers(name);
    if (name != "E0") continue;
    for (const char part : std::string("xyz").substr(0, static_cast<std::size_t>(dimension())))
      add_numbers(std::string("E0_") + part);
    add_numbers("|E0|");
    if (hint_.abscissa == "R" || hint_.abscissa == "r") add_numbers("E0_" + hint_.abscissa);
  }
}

void PlotItem::add_numbers(const std::string& name) {
  if (name == "x") {
    const std::vector<Array3>& x = content_.particles.x;
    json["numbers"]["x"] = files_.add({x.empty() ? nullptr : x[0].data(), 3 * x.size()}, {x.size(), 3});
    return;
  }
  json["numbers"][name] = files_.add(values(name));
  json["parts"][name] = field(name).part;
}

void PlotItem::add_map(const std::string& name, const MapView& view) {
  const ParticleSet& gas = content_.particles;
  const std::string shown = name == "v" ? "|v|" : name;  // a map has no direction of its own
  std::vector<double> volume = values("m");
  const std::vector<double> rho = values("rho"), value = values(shown);
  for (std::size_t i = 0; i < volume.size(); ++i) volume[i] /= rho[i];
  const std::array<double, 4> all = extent();
  const std::vector<double> window = view.window.empty() ? std::vector(all.begin(), all.end()) : view.window;
  PictureFrame frame{.dimension = dimension(),
                     .box = gas.box,
                     .lower = {window[0], window[2]},
                     .size = {window[1] - window[0], window[3] - window[2]},
                     .pixels = {}};
  frame.pixels = pixels_of(frame.size, view.pixels);
  if (dimension() == 3 && !view.column) frame.z = view.slice.value_or(gas.box.lower[2] + 0.5 * gas.box.size[2]);
  const FieldMap map = project({{gas.x.empty() ? nullptr : gas.x[0].data(), 3 * gas.size()}, volume, value}, frame);
  const std::vector<std::size_t> shape{static_cast<std::size_t>(frame.pixels[1]),
                                       static_cast<std::size_t>(frame.pixels[0])};
  // Gas ends in open boxes; a hole in a closed one is thin gas.
  const bool fades = !map.cover.empty() && !fills_box();
  json["images"][name] = {{"values", files_.add_image(map.values, shape)},
                          {"cover", fades ? Json(files_.add_image(map.cover, shape)) : Json(nullptr)},
                          {"window", window},
                          {"z", frame.z ? Json(*frame.z) : Json(nullptr)},
                          {"column", dimension() == 3 && view.column}};
  json["parts"][name] = field(shown).part;
}

}  // namespace sphk
