#include "src/scenes/scenes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/engine/errors.hpp"

namespace sphk {

const std::vector<const Scene*>& scenes() {
  static const std::vector<const Scene*> table{&sod_scene(),    &sod_multimass_scene(), &tube_scene(),
                                               &gresho_scene(), &sedov_scene(),         &point_explosion_scene(),
                                               &noh_scene(),    &expansion_scene(),     &kh12_scene(),
                                               &kh18_scene(),   &mcnally_scene(),       &shearing_scene(),
                                               &blob_scene(),   &ring_scene(),          &square_scene(),
                                               &odd_scene(),    &uniform_scene()};
  return table;
}

const Scene& find_scene(const std::string& name) {
  Settings names;  // borrowed for its search by edit distance
  for (const Scene* scene : scenes()) {
    if (scene->name() == name) return *scene;
    names.declare({.name = scene->name(), .value = false, .doc = {}, .choices = {}});
  }
  throw InputError(fmt::format("there is no scene \"{}\"; did you mean \"{}\"? `sphk list` shows them all", name,
                               names.nearest(name)));
}

}  // namespace sphk
