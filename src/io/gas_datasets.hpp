#pragma once

#include <vector>

#include "src/engine/particle_set.hpp"
#include "src/io/hdf5_file.hpp"
#include "src/io/reader.hpp"

namespace sphk {

/// The gas of one file: what a PartType0 group holds, under whichever names and shapes.
struct GasDatasets {
  int columns = 3;  ///< components per row of Coordinates
  std::vector<Array3> x, v;
  std::vector<double> m, u, h;    ///< h is empty where the file has none
  std::vector<double> alpha;      ///< empty where the file has none
  std::vector<std::uint64_t> id;  ///< empty where the file has none
};

/// Reads a PartType0 group; `table_mass` stands in for missing Masses when it is positive. Throws InputError on missing
/// datasets, wrong types, shapes that disagree and, with NonFinite::refuse, on NaN and infinities.
GasDatasets read_gas(const hdf5::Group& gas, double table_mass, NonFinite non_finite);

}  // namespace sphk
