// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/engine/particle_set.hpp"
#include "src/io/hdf5_file.hpp"
#include "src/io/readers_box.hpp"
#include "src/io/snapshot_writer.hpp"

namespace sphk {

/// Version of the attributes of /sphk; to be raised when a reader would have to tell old from new.
inline constexpr int snapshot_schema = 1;

/// Everything in a snapshot that is not a field: Header, Units, InternalCodeUnits, Policy, RuntimePars, Cosmology,
/// SubgridScheme, Parameters, HydroScheme, Code and /sphk. Names, types and shapes are SWIFT's.
void write_metadata(hdf5::File& file, const Snapshot& snapshot, const SnapshotInfo& info, const ReadersBox& box);

/// The Cells group, by which readers of SWIFT files find a region: one cell that holds all particles, which readers see
/// at `coordinates`.
void write_cells(hdf5::File& file, const std::vector<double>& coordinates, const ReadersBox& box);

/// Writes a snapshot to a new file, which others may add to.
void write_snapshot(hdf5::File& file, Snapshot snapshot, const SnapshotInfo& info, Compression compression);

}  // namespace sphk
