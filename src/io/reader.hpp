// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "src/engine/particle_set.hpp"
#include "src/io/units.hpp"

namespace sphk {

/// What a file gave: the gas, and sentences on what was assumed, made or left out, for the user to read.
struct ReadResult {
  ParticleSet particles;
  std::optional<double> gamma;  ///< adiabatic index, when the file says it
  std::optional<Units> units;   ///< when the file says them; code units are none
  bool dimension_said = false;  ///< by the file, not only by three columns of Coordinates
  bool own_snapshot = false;    ///< written by sphk: `h` holds converged support radii
  std::vector<std::string> remarks;
};

/// What read_particles does with NaN and infinities: throw at the first one, or pass them on to check_particles.
enum class NonFinite { refuse, keep };

/// Reads the gas of an HDF5 file: initial conditions of SWIFT, GADGET-2/4, AREPO and GIZMO, and sphk's own snapshots.
/// Singular and plural names, any number type, (N), (N,1), (N,2) and (N,3) shapes, MassTable, several files (x.0.hdf5:
/// any of the parts, or x.hdf5, may be named) are taken as they come; missing ids are made, missing h is left empty.
/// Rows stay in the file's order. Throws InputError naming file, dataset and index, and the way to mend it.
ReadResult read_particles(const std::filesystem::path& path, NonFinite non_finite = NonFinite::refuse);

/// Makes the gas one of fewer dimensions: what it has along the others becomes 0. The number of rows that change.
std::size_t drop_axes(ParticleSet& gas, int dimension);

}  // namespace sphk
