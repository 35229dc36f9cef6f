// SPDX-License-Identifier: BSD-3-Clause
#include "src/schemes/shared_object.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <sphk_abi.hpp>
#include <string>

#include "src/engine/errors.hpp"

namespace sphk {

namespace fs = std::filesystem;

SharedObject::SharedObject(const fs::path& file) : file_(file) {
  if (!fits_this_build(file))
    throw InputError(
        fmt::format("module {}: it was not compiled against this sphk; compile it (again) with the headers of the one "
                    "that loads it",
                    file.string()));
  handle_ = dlopen(fs::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
  // The system's own sentence says which symbol or library is missing.
  if (!handle_) throw InputError(fmt::format("module {}: it cannot be loaded: {}", file.string(), dlerror()));
}

void* SharedObject::symbol(const char* name) const {
  void* address = dlsym(handle_, name);
  if (!address)
    throw InputError(fmt::format("module {}: it defines no function {}; declare it as extern \"C\" void {}(...)",
                                 file_.string(), name, name));
  return address;
}

bool fits_this_build(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  return bytes.find(SPHK_ABI) != std::string::npos;
}

}  // namespace sphk
