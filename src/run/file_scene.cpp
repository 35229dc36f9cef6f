#include "src/run/file_scene.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/engine/errors.hpp"
#include "src/io/check.hpp"
#include "src/io/hdf5_file.hpp"
#include "src/schemes/registry.hpp"

namespace sphk {

PlotHint plain_hint(const Box& box) {
  return {.abscissa = "x",
          .fields = {"rho", "v", "P"},
          .from = box.lower[0],
          .to = box.lower[0] + box.size[0],
          .centre = {}};
}

FileScene::FileScene(const std::filesystem::path& path)
    : path_(std::filesystem::absolute(path)), content_(read_particles(path)) {
  if (content_.particles.size() == 0) errors_.emplace_back("it holds no gas particles: at least one is needed");
  for (const Finding& finding : check_particles(content_.particles))
    (finding.severity == Finding::Severity::error ? errors_ : content_.remarks).push_back(to_text(finding));
  if (content_.own_snapshot) read_method();
}

std::string FileScene::summary() const {
  return "the initial condition " + path_.string();
}

void FileScene::declare(Settings& settings) const {
  settings.declare({.name = "scene.file", .value = path_.string(), .doc = "the initial condition", .choices = {}});
  settings.declare({.name = "scene.periodic",
                    .value = std::string("file"),
                    .doc = "boundaries of all axes: as the file says, or as asked",
                    .choices = {"file", "yes", "no"}});
  if (content_.gamma) settings.prefer("sph.gamma", *content_.gamma);
  settings.prefer("time.end", content_.particles.time);
  for (const auto& [name, text] : method_) settings.prefer_from_text(name, text);
}

void FileScene::read_method() {
  const hdf5::File file = hdf5::File::open(path_);
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
      content_.remarks.push_back(fmt::format("the snapshot's key is not taken over: {}", error.what()));
    }
  }
}

ParticleSet FileScene::build(const Settings& settings) const {
  if (!errors_.empty())
    throw InputError(
        fmt::format("{} cannot be run before this is mended:\n  {}", path_.string(), fmt::join(errors_, "\n  ")));
  ParticleSet particles = content_.particles;
  const std::string& periodic = settings.text("scene.periodic");
  for (int axis = 0; axis < particles.dimension && periodic != "file"; ++axis)
    particles.box.periodic[static_cast<std::size_t>(axis)] = periodic == "yes";
  return particles;
}

PlotHint FileScene::plot_hint(const Settings&) const {
  return plain_hint(content_.particles.box);
}

}  // namespace sphk
