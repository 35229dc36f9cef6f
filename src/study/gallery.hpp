#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sphk {

struct GalleryRequest {
  std::optional<std::filesystem::path> out;  ///< nothing: "gallery"
  std::vector<std::string> scenes;           ///< empty: all
  int threads = 0;                           ///< of each run; 0: what OpenMP gives
};

/// A small run of every scene, each a process of its own, and one page with them all: index.html and gallery.png in the
/// folder. Tells on standard output how far it is. Returns whether every run came to its end; a signal stops it
/// (stop_signal.hpp), without a page. Throws InputError.
bool make_gallery(const GalleryRequest& request);

}  // namespace sphk
