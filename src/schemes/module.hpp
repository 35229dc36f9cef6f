// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernels/smoothing/own_kernel.hpp"
#include "src/engine/recipe_parts.hpp"
#include "src/schemes/instantiate.hpp"
#include "src/schemes/scheme_entry.hpp"

namespace sphk {

class Scene;

/// What a shared object of one's own brings to every command (--module FILE, SPHK_MODULE_PATH). It defines
///
///   extern "C" void sphk_module(sphk::Module& mine) { mine.add_scheme<Rubbing>(); ... }
///
/// and is compiled against the headers of the very sphk that loads it (docs/examples/own_module.cpp).
struct Module {
  Catalogue schemes;
  Instantiations rows;  ///< of these
  std::vector<OwnKernel> kernels;
  std::vector<const Scene*> scenes;

  /// A scheme, where its recipes have kernels for 1D, 2D and 3D: a struct with `facts` and `Recipes`.
  template <class S>
  void add_scheme() {
    schemes.push_back(scheme_entry<S>());
    std::ranges::move(all_rows_of<S>(), std::back_inserter(rows));
  }
  /// A smoothing kernel for every scheme: through the table, unless a scheme has it in closed form.
  template <class Kernel>
  void add_kernel() {
    kernels.push_back(OwnKernel::of<Kernel>());
  }
  /// A scene, which lives as long as the program.
  void add_scene(const Scene& scene) { scenes.push_back(&scene); }
};

}  // namespace sphk
