// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "src/engine/saved_state.hpp"
#include "src/io/snapshot_writer.hpp"

namespace sphk {

/// The version of what a checkpoint holds and of how a simulation's saved state is laid out: to be raised with each
/// change of either, so that no run goes on from a state that means something else.
inline constexpr int checkpoint_layout = 3;

/// What is around a simulation in a run that can be gone on with.
struct Checkpoint {
  std::string loop;        ///< what the loop knows, as JSON
  std::string history;     ///< the text of history.csv until then
  std::string scene;       ///< the text of scene.used.toml; written as that of the snapshot
  GiveBlock simulation{};  ///< the blocks of its saved state, read from the file when they are asked for
};

/// Writes a snapshot with the checkpoint in its group /sphk/Checkpoint; its scene's text is that of `info`. `save`
/// hands over the blocks of the simulation's state; one is in memory at a time. The file appears under its name only
/// when it is complete and on the disk. Errors as for write_snapshot.
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& around,
                      const std::function<void(const TakeBlock&)>& save, Snapshot snapshot, const SnapshotInfo& info);

/// Reads it back. Throws InputError where the file is none, is of another layout, or its checksum tells that it is
/// damaged.
Checkpoint read_checkpoint(const std::filesystem::path& path);

}  // namespace sphk
