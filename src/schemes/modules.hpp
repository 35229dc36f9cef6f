// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace sphk {

class Scene;

/// Adds files to the environment's SPHK_MODULE_PATH, which runs that this process starts inherit.
void add_to_module_path(const std::vector<std::string>& files);
/// Loads the shared objects that SPHK_MODULE_PATH names: files, and folders of *.so, with colons between. What they
/// bring (module.hpp) is known from then on. Throws InputError where one is none, was compiled against another sphk, or
/// brings a name that is taken.
void load_modules();
/// Of all that are loaded.
const std::vector<const Scene*>& scenes_of_modules();

}  // namespace sphk
