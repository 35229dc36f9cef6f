// SPDX-License-Identifier: BSD-3-Clause
#include "src/schemes/modules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "src/engine/errors.hpp"
#include "src/schemes/compiled.hpp"
#include "src/schemes/compiled_rows.hpp"
#include "src/schemes/module.hpp"
#include "src/schemes/registry.hpp"
#include "src/schemes/shared_object.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

struct Loaded {
  Catalogue catalogue = catalogue_of_build();
  std::vector<Module> modules;
  std::vector<const Scene*> scenes;
  std::set<fs::path> files;
};

Loaded& loaded() {
  static Loaded all;
  return all;
}

void require_new(const fs::path& file, const char* what, const std::string& name,
                 const std::vector<std::string>& known) {
  if (std::ranges::find(known, name) != known.end())
    throw InputError(fmt::format("module {}: it brings a {} \"{}\", which is there already; give it another name",
                                 file.string(), what, name));
}

void take(Module mine, const fs::path& file) {
  Loaded& all = loaded();
  for (const SchemeEntry& scheme : mine.schemes) require_new(file, "scheme", scheme.facts->name, scheme_names());
  for (const OwnKernel& kernel : mine.kernels)
    require_new(file, "smoothing kernel", std::string(kernel.known_as), kernel_names());
  std::ranges::copy(mine.schemes, std::back_inserter(all.catalogue));
  std::ranges::copy(mine.kernels, std::back_inserter(own_kernels()));
  std::ranges::copy(mine.scenes, std::back_inserter(all.scenes));
  all.modules.push_back(std::move(mine));
}

Instantiations matching(const Instantiations& rows, const std::string& scheme, int dimension) {
  Instantiations own;
  std::ranges::copy_if(rows, std::back_inserter(own), [&](const Instantiation& row) {
    return row.scheme->name == scheme && row.dimension == dimension;
  });
  return own;
}

Instantiations find_rows(const std::string& scheme, int dimension) {
  for (const Module& module : loaded().modules)
    if (std::ranges::any_of(module.schemes, [&](const SchemeEntry& own) { return own.facts->name == scheme; }))
      return matching(module.rows, scheme, dimension);
  return rows_of_build(scheme, dimension);
}

void load_module(const fs::path& file) {
  if (!fs::is_regular_file(file))
    throw InputError(fmt::format("module {}: there is no such file; give the path of a shared object", file.string()));
  if (!loaded().files.insert(fs::canonical(file)).second) return;
  const auto fill = SharedObject(file).function<void(Module&)>("sphk_module");
  Module mine;
  fill(mine);
  take(std::move(mine), file);
}

}  // namespace

void add_to_module_path(const std::vector<std::string>& files) {
  const char* before = std::getenv("SPHK_MODULE_PATH");
  std::string path = before ? before : "";
  for (const std::string& file : files) path += (path.empty() ? "" : ":") + fs::absolute(file).string();
  setenv("SPHK_MODULE_PATH", path.c_str(), 1);
}

void load_modules() {
  const char* path = std::getenv("SPHK_MODULE_PATH");
  std::istringstream places(path ? path : "");
  for (std::string place; std::getline(places, place, ':');) {
    if (place.empty()) continue;
    if (!fs::is_directory(place)) {
      load_module(place);
      continue;
    }
    std::set<fs::path> files;  // in the order of their names
    for (const auto& entry : fs::directory_iterator(place))
      if (entry.path().extension() == ".so") files.insert(entry.path());
    for (const fs::path& file : files) load_module(file);
  }
}

const std::vector<const Scene*>& scenes_of_modules() {
  return loaded().scenes;
}

const Catalogue& known_schemes() {
  return loaded().catalogue;
}

const Instantiations& compiled_rows(const std::string& scheme, int dimension) {
  static std::map<std::pair<std::string, int>, Instantiations> found;
  const std::pair key(scheme, dimension);
  const auto there = found.find(key);
  return (there != found.end() ? there : found.emplace(key, find_rows(scheme, dimension)).first)->second;
}

}  // namespace sphk
