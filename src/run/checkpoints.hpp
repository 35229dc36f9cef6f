// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "src/engine/simulation.hpp"
#include "src/run/run_output.hpp"

namespace sphk {

/// What a run's loop knows beside the simulation.
struct LoopState {
  double begin = 0;  ///< time at the start of the run
  long steps = 0;
  double wall = 0, cpu = 0;
  std::optional<double> joules;
  long next_snapshot = 1;
  std::size_t next_row = 0;      ///< of the plan's further rows
  std::size_t next_heating = 0;  ///< of the plan's
};

/// A run as a checkpoint holds it.
struct SavedRun {
  LoopState loop;
  OutputState output;
  Box box;
  std::filesystem::path file;
  GiveBlock simulation;
  std::string history, scene;        ///< the texts of history.csv and scene.used.toml
  std::vector<std::string> remarks;  ///< on checkpoints that could not be read
};

/// The scene file that a checkpoint holds.
struct SavedScene {
  std::string text;
  std::filesystem::path file;  ///< the checkpoint
};

/// That of the newest checkpoint of a folder; nothing where there is none that can be read.
std::optional<SavedScene> newest_scene(const std::filesystem::path& folder);

/// Has a file with this text lost its end, or all of it? One that the user has changed has not.
inline bool is_cut_short(const std::string& text, const std::string& whole) {
  return text.size() < whole.size() && whole.starts_with(text);
}

/// Writes history.csv and scene.used.toml anew where they are lost or hold less than the checkpoint.
void restore_files(const std::filesystem::path& folder, const SavedRun& saved);

/// The checkpoints of a run's folder: two files that are written in turns, so that one is always complete.
class Checkpoints {
 public:
  /// `last`: the file that the run goes on from, which is written last.
  explicit Checkpoints(std::filesystem::path folder, const std::filesystem::path& last = {});

  /// Throws InputError where it cannot be written.
  void write(const Simulation& simulation, const LoopState& loop, const OutputState& output, const Box& box,
             const SnapshotInfo& info);
  /// Wall-clock seconds that the last one took.
  double seconds() const { return seconds_; }
  bool any() const;
  /// Once a run is complete.
  void remove() const;

 private:
  std::filesystem::path folder_;
  int next_ = 0;
  double seconds_ = 0;
};

/// The newest checkpoint of a folder that is whole, and of a run of this scene with these keys, but for those that may
/// change. Throws InputError where there is none.
SavedRun newest_checkpoint(const std::filesystem::path& folder, const Scene& scene, const Settings& settings);

}  // namespace sphk
