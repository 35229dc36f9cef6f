// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/file_scene.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/engine/errors.hpp"
#include "src/io/hdf5_file.hpp"
#include "src/run/unit_keys.hpp"
#include "src/scenes/keys.hpp"
#include "src/schemes/registry.hpp"

namespace sphk {

PlotHint plain_hint(const Box& box) {
  return {.abscissa = "x",
          .fields = {"rho", "v", "P"},
          .from = box.lower[0],
          .to = box.lower[0] + box.size[0],
          .centre = {}};
}

FileScene::FileScene(const std::filesystem::path& path, const std::filesystem::path& particles)
    : path_(std::filesystem::absolute(path)),
      particles_(std::filesystem::absolute(particles)),
      content_(read_particles(particles)),
      verdict_(judge(content_)),
      doubt_(dimension_in_doubt(content_)) {
  ParticleSet& gas = content_.particles;
  gas = {.dimension = gas.dimension, .box = gas.box, .time = gas.time};
  if (content_.own_snapshot) read_method(particles);
}

std::string FileScene::summary() const {
  return "the initial condition " + path_.string();
}

void FileScene::declare(Settings& settings) const {
  settings.declare({.name = "scene.file", .value = path_.string(), .doc = "the initial condition", .choices = {}});
  declare_dimension(settings, content_.particles.dimension);
  settings.declare({.name = "scene.periodic",
                    .value = std::string("file"),
                    .doc = "boundaries of all axes: as the file says, or as asked",
                    .choices = {"file", "yes", "no"}});
  if (content_.gamma) settings.prefer("sph.gamma", *content_.gamma);
  settings.prefer("time.end", content_.particles.time);
  if (content_.units) prefer_units(settings, *content_.units);
  for (const auto& [name, text] : method_) settings.prefer_from_text(name, text);
}

void FileScene::read_method(const std::filesystem::path& snapshot) {
  const hdf5::File file = hdf5::File::open(snapshot);
  if (!file.has("Parameters")) return;
  const hdf5::Group saved = file.group("Parameters");
  Settings known;
  declare_engine_keys(known);
  const std::vector<Key> keys = known.keys();
  for (const Key& key : keys) {
    std::string name = key.name;
    std::ranges::replace(name, '.', ':');
    if (!saved.has_attribute(name)) continue;
    try {
      known.prefer_from_text(key.name, saved.text(name));
      method_.emplace_back(key.name, saved.text(name));
    } catch (const InputError& error) {
      verdict_.notes.push_back(fmt::format("the snapshot's key is not taken over: {}", error.what()));
    }
  }
}

void FileScene::set_dimension(ParticleSet& gas, const Settings& settings) const {
  const int wanted = scene_dimension(settings);
  if (wanted > gas.dimension)
    throw InputError(
        fmt::format("scene.dimension = {}: the gas of {} is {}D; take that, or write {} columns of "
                    "Coordinates and the attribute Dimension of Header",
                    wanted, path_.string(), gas.dimension, wanted));
  const auto differs = [&](const Array3& x, const Array3& v) {
    for (auto k = static_cast<std::size_t>(wanted); k < 3; ++k)
      if (x[k] != gas.x[0][k] || v[k] != 0) return true;
    return false;
  };
  for (std::size_t i = 0; i < gas.size() && wanted < gas.dimension; ++i)
    if (differs(gas.x[i], gas.v[i]))
      throw InputError(
          fmt::format("scene.dimension = {}: row {} of {} moves along another axis or lies elsewhere there "
                      "than row 0; gas of {}D does neither",
                      wanted, i, path_.string(), wanted));
  if (wanted < gas.dimension) drop_axes(gas, wanted);
}

ParticleSet FileScene::build(const Settings& settings) const {
  std::vector<std::string> errors = verdict_.errors;
  if (!doubt_.empty() && !settings.set_by_user("scene.dimension")) errors.push_back(doubt_);
  if (!errors.empty())
    throw InputError(
        fmt::format("{} cannot be run before this is mended:\n  {}", path_.string(), fmt::join(errors, "\n  ")));
  ParticleSet particles = read_particles(particles_).particles;
  particles.h = std::vector<double>();  // a run finds its own
  set_dimension(particles, settings);
  const std::string& periodic = settings.text("scene.periodic");
  for (int axis = 0; axis < particles.dimension && periodic != "file"; ++axis)
    particles.box.periodic[static_cast<std::size_t>(axis)] = periodic == "yes";
  return particles;
}

PlotHint FileScene::plot_hint(const Settings&) const {
  return plain_hint(content_.particles.box);
}

}  // namespace sphk
