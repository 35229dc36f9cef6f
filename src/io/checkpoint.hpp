#pragma once

#include <filesystem>
#include <string>

#include "src/engine/saved_state.hpp"
#include "src/io/snapshot_writer.hpp"

namespace sphk {

/// A run as it can be gone on with: the simulation, and what the loop around it knows.
struct Checkpoint {
  SavedState state;
  std::string loop;  ///< JSON
};

/// Writes a snapshot with the checkpoint in its group /sphk/Checkpoint; it appears under its name only when it is
/// complete and on the disk. Errors as for write_snapshot.
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint, const Snapshot& snapshot,
                      const SnapshotInfo& info);

/// Reads it back. Throws InputError where the file is none, or its checksum tells that it is damaged.
Checkpoint read_checkpoint(const std::filesystem::path& path);

}  // namespace sphk
