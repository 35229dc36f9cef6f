#pragma once

#include <string>
#include <utility>
#include <vector>

namespace sphk {

/// A scene as the gallery shows it: small enough for a few seconds on a laptop.
struct GalleryTile {
  std::string scene;
  std::vector<std::pair<std::string, std::string>> keys;
  std::string field;  ///< drawn along the scene's abscissa, beside the exact solution; empty: a map of the density
};

/// One tile for every scene, in the order of `sphk list`.
const std::vector<GalleryTile>& gallery_tiles();

}  // namespace sphk
