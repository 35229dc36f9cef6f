#pragma once

#include "src/scenes/scene.hpp"

namespace sphk {

const Scene& sod_scene();
const Scene& gresho_scene();
const Scene& sedov_scene();
const Scene& noh_scene();
const Scene& uniform_scene();

}  // namespace sphk
