// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/places.hpp"

#include <dlfcn.h>

namespace sphk {

namespace fs = std::filesystem;

fs::path library_folder() {
  Dl_info place{};
  dladdr(reinterpret_cast<const void*>(&library_folder), &place);
  const fs::path file = place.dli_fname ? place.dli_fname : "";
  // Of a program that is one file the system knows what it was started as, which need be no path.
  return (file.is_absolute() ? fs::canonical(file) : fs::read_symlink("/proc/self/exe")).parent_path();
}

fs::path shared_folder() {
  return library_folder().parent_path() / "share/sphk";
}

}  // namespace sphk
