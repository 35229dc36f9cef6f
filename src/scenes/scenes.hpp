#pragma once

#include "src/scenes/scene.hpp"

namespace sphk {

const Scene& sod_scene();
const Scene& sod_multimass_scene();
const Scene& tube_scene();
const Scene& gresho_scene();
const Scene& sedov_scene();
const Scene& point_explosion_scene();
const Scene& noh_scene();
const Scene& expansion_scene();
const Scene& kh12_scene();
const Scene& kh18_scene();
const Scene& mcnally_scene();
const Scene& shearing_scene();
const Scene& blob_scene();
const Scene& ring_scene();
const Scene& square_scene();
const Scene& odd_scene();
const Scene& uniform_scene();

}  // namespace sphk
