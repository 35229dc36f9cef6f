// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <numeric>
#include <vector>

#include "src/engine/particle_set.hpp"
#include "src/io/hdf5_file.hpp"

namespace sphk {

/// Writes gas as other codes do, with SWIFT's names and no group of sphk's own; ids from 1. The box begins at 0; all of
/// its axes are periodic, or none. A dimension of 0 is not written.
inline void write_gas_file(const std::filesystem::path& path, const ParticleSet& gas) {
  hdf5::File file = hdf5::File::create();
  hdf5::Group header = file.create_group("Header");
  header.set("BoxSize", std::vector(gas.box.size.begin(), gas.box.size.end()));
  if (gas.dimension > 0) header.set("Dimension", gas.dimension);
  header.set("Time", gas.time);
  file.create_group("RuntimePars").set("PeriodicBoundariesOn", gas.box.periodic[0] ? 1 : 0);
  hdf5::Group part = file.create_group("PartType0");
  const auto vectors = [&](const char* name, const std::vector<Array3>& rows) {
    std::vector<double> values;
    for (const Array3& row : rows) values.insert(values.end(), row.begin(), row.end());
    part.write(name, values, 3);
  };
  vectors("Coordinates", gas.x);
  vectors("Velocities", gas.v);
  part.write("Masses", gas.m);
  part.write("InternalEnergies", gas.u);
  part.write("SmoothingLengths", gas.h);
  std::vector<std::uint64_t> ids(gas.size());
  std::iota(ids.begin(), ids.end(), std::uint64_t{1});
  part.write("ParticleIDs", ids);
  file.save(path);
}

}  // namespace sphk
