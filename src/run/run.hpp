// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "src/report/progress.hpp"
#include "src/report/run_record.hpp"
#include "src/run/checkpoints.hpp"
#include "src/run/problem.hpp"
#include "src/run/run_output.hpp"

namespace sphk {

/// What to run, where to, and how to tell of it.
struct RunRequest {
  std::string what;                              ///< a scene, a scene file or an initial condition
  std::vector<Override> overrides;               ///< of its keys
  std::optional<std::filesystem::path> out;      ///< the run's folder; nothing: NAME-run, or the next free one
  bool overwrite = false;                        ///< replace the run that the folder holds
  std::optional<std::filesystem::path> resume;   ///< the folder of a run to go on with; `what` is empty then
  double watch = 0;                              ///< wall-clock seconds between pictures of the run as it is; 0: none
  double walltime = 0;                           ///< wall-clock seconds after which the run stops; 0: no limit
  ProgressStyle progress = ProgressStyle::none;  ///< on standard output
  bool stop_on_signals = false;                  ///< SIGTERM and the like end it with a checkpoint (stop_signal.hpp)
};

/// What a run came to.
struct RunResult {
  RunRecord record;  ///< as in run.json; `finished` is false where it was stopped, and can go on
  std::filesystem::path folder;
};

/// The problem that a request names. Throws InputError.
Problem problem_of(const RunRequest& request);

/// What is known of a run before its first step, and what it came to.
RunRecord make_record(const Problem& problem, const ParticleSet& particles);
void add_results(RunRecord& record, const LoopState& done, const RunOutput& output, const Simulation& simulation,
                 const Box& box);

/// Runs to the end time, or until it is stopped, and leaves the run's folder: snapshots, history.csv, run.json,
/// scene.used.toml; a stopped run a checkpoint as well. Kokkos must be running. Throws InputError, and NumericsError
/// where the numbers go wrong; run.json and the snapshots until then are kept.
RunResult run(const RunRequest& request);

}  // namespace sphk
