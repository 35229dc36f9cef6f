// SPDX-License-Identifier: BSD-3-Clause

// io_example write FILE DIMENSION: an example snapshot. io_example read FILE: the gas of FILE as text, one row each.
// For layout.py, which looks at files with h5py instead of our own HDF5 layer.
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "src/io/reader.hpp"
#include "tests/io/example.hpp"

int main(int argc, char** argv) {
  if (argc == 4 && std::strcmp(argv[1], "write") == 0) {
    sphk::write_snapshot(argv[2], sphk::example_snapshot(std::atoi(argv[3]), 50), sphk::example_info());
    return 0;
  }
  if (argc != 3 || std::strcmp(argv[1], "read") != 0) return 2;
  const sphk::ParticleSet p = sphk::read_particles(argv[2]).particles;
  for (std::size_t i = 0; i < p.size(); ++i)
    std::printf("%.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %llu\n", p.x[i][0], p.x[i][1], p.x[i][2], p.v[i][0],
                p.v[i][1], p.v[i][2], p.m[i], p.u[i], static_cast<unsigned long long>(p.id[i]));
  return 0;
}
