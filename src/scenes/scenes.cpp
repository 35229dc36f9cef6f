// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "src/engine/errors.hpp"
#include "src/engine/hint.hpp"
#include "src/schemes/modules.hpp"

namespace sphk {

std::span<const Array3> rows(const Field& field) {
  static_assert(sizeof(Array3) == 3 * sizeof(double));
  return {reinterpret_cast<const Array3*>(field.values.data()), field.values.size() / 3};
}

int Scene::dimension(const Settings& settings) const {
  return settings.has("scene.dimension") ? static_cast<int>(settings.integer("scene.dimension")) : 3;
}

const std::vector<const Scene*>& scenes() {
#define SPHK_ADDRESS_OF_SCENE(name) &name##_scene,
  static std::vector<const Scene*> table{SPHK_SCENES(SPHK_ADDRESS_OF_SCENE)};
#undef SPHK_ADDRESS_OF_SCENE
  static const std::size_t of_this_build = table.size();
  table.resize(of_this_build);
  std::ranges::copy(scenes_of_modules(), std::back_inserter(table));
  return table;
}

const Scene& find_scene(const std::string& name) {
  Settings names;  // borrowed for its search by edit distance
  for (const Scene* scene : scenes()) {
    if (scene->name() == name) return *scene;
    names.declare({.name = scene->name(), .value = false, .doc = {}, .choices = {}});
  }
  throw InputError(
      fmt::format("there is no scene \"{}\"; {} `sphk list` shows them all", name,
                  hint(names.nearest(name), "is it the name of a file? Its path needs a slash or .hdf5.")));
}

}  // namespace sphk
