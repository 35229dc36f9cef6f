#include "src/schemes/shared_object.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <sphk_abi.hpp>
#include <string>
#include <string_view>

#include "src/engine/errors.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

/// Of the headers that the object was compiled against (sphk_abi.hpp), or nothing.
std::string_view headers_of(void* handle) {
  const void* text = handle ? dlsym(handle, "sphk_abi") : nullptr;
  return text ? static_cast<const char*>(text) : std::string_view{};
}

/// The system's own sentence says which symbol or library is missing.
void* open(const fs::path& file) {
  void* handle = dlopen(fs::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) throw InputError(fmt::format("module {}: it cannot be loaded: {}", file.string(), dlerror()));
  return handle;
}

}  // namespace

SharedObject::SharedObject(const fs::path& file) : file_(file), handle_(open(file)) {
  if (headers_of(handle_) != SPHK_ABI)
    throw InputError(
        fmt::format("module {}: it was compiled against another sphk than this one; compile it again", file.string()));
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
