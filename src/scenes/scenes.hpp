// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/scenes/scene.hpp"

/// Every scene, in the order of `sphk list`. NAME_scene is made in the scene's own file, before main begins.
#define SPHK_SCENES(SCENE) \
  SCENE(sod)               \
  SCENE(sod_multimass)     \
  SCENE(tube)              \
  SCENE(gresho)            \
  SCENE(sedov)             \
  SCENE(point_explosion)   \
  SCENE(noh)               \
  SCENE(expansion)         \
  SCENE(kh12)              \
  SCENE(kh18)              \
  SCENE(mcnally)           \
  SCENE(shearing)          \
  SCENE(blob)              \
  SCENE(ring)              \
  SCENE(square)            \
  SCENE(odd)               \
  SCENE(uniform)

namespace sphk {

#define SPHK_DECLARE_SCENE(name) extern const Scene& name##_scene;
SPHK_SCENES(SPHK_DECLARE_SCENE)
#undef SPHK_DECLARE_SCENE

}  // namespace sphk
