// SPDX-License-Identifier: BSD-3-Clause

// make_glasses FOLDER: the glasses that come with sphk, those of the usual scenes, anew (cmake --build build --target
// glasses).
#include <Kokkos_Core.hpp>
#include <cstdio>

#include "src/scenes/glass.hpp"

int main(int argc, char** argv) {
  const Kokkos::ScopeGuard kokkos(argc, argv);
  if (argc != 2) return std::fprintf(stderr, "make_glasses FOLDER\n"), 2;
  for (const auto& [dimension, counts] : {std::pair(3, sphk::GridCounts{32, 32, 32}),
                                          {3, {32, 16, 16}},
                                          {3, {16, 16, 16}},
                                          {3, {16, 8, 8}},
                                          {2, {64, 64, 1}},
                                          {2, {32, 32, 1}}}) {
    const sphk::Array3 size{double(counts[0]), double(counts[1]), double(counts[2])};
    const auto points = sphk::relax_with_engine(dimension, size, sphk::glass_start(dimension, counts));
    sphk::write_glass(std::filesystem::path(argv[1]) / sphk::glass_file_name(dimension, counts), dimension, counts,
                      points);
  }
}
