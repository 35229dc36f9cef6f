#pragma once

#include <filesystem>
#include <vector>

namespace sphk {

class Scene;

/// Loads a shared object; what it brings is known from then on. Throws InputError where it is none, was compiled
/// against another sphk, or brings a name that is taken.
void load_module(const std::filesystem::path& file);
/// Those that SPHK_MODULE_PATH names: files, and folders of *.so, with colons between.
void load_modules_of_environment();
/// Of all that are loaded.
const std::vector<const Scene*>& scenes_of_modules();

}  // namespace sphk
