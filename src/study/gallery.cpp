#include "src/study/gallery.hpp"

namespace sphk {

const std::vector<GalleryTile>& gallery_tiles() {
  static const std::vector<GalleryTile> tiles{
      {"sod", {}, "rho"},
      {"sod-multimass", {{"scene.n", "32"}, {"scene.across", "16"}}, "rho"},
      {"tube", {}, "v"},
      {"gresho",
       {{"scene.n", "32"},
        {"scene.lattice", "glass"},
        {"sph.scheme", "sphs-morris"},
        {"sph.kernel", "hoct4"},
        {"sph.neighbours", "442"},
        {"time.courant", "0.4"}},
       "v"},
      {"sedov",
       {{"scene.n", "48"}, {"sph.scheme", "sphs-conservative"}, {"sph.kernel", "hoct4"}, {"sph.neighbours", "442"}},
       "rho"},
      {"point-explosion", {{"scene.n", "24"}}, ""},
      {"noh", {{"scene.n", "100"}, {"scene.dimension", "2"}}, "rho"},
      {"expansion", {}, "rho"},
      {"kh12", {{"scene.n", "64"}, {"scene.dimension", "2"}, {"scene.edges", "soft"}, {"time.end", "4.82118"}}, ""},
      {"kh18",
       {{"scene.n", "64"},
        {"scene.dimension", "2"},
        {"scene.edges", "soft"},
        {"scene.masses", "multi"},
        {"time.end", "7.2318"}},
       ""},
      {"mcnally", {{"scene.n", "96"}}, ""},
      {"shearing",
       {{"scene.n", "64"},
        {"scene.mach", "0.2"},
        {"sph.scheme", "sphs"},
        {"sph.kernel", "wc6"},
        {"sph.neighbours", "100"},
        {"time.end", "1.684"}},
       ""},
      {"blob", {{"scene.n", "32"}, {"time.end", "3.748"}}, ""},
      {"ring", {{"scene.n", "32"}, {"time.end", "12.566"}}, ""},
      {"square", {{"scene.n", "32"}}, ""},
      {"odd", {{"scene.problem", "ten"}, {"scene.n", "16"}}, ""},
      {"uniform", {{"scene.n", "24"}}, "rho"}};
  return tiles;
}

}  // namespace sphk
