// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/report/conservation.hpp"
#include "src/report/deviations.hpp"
#include "src/report/error_budget.hpp"
#include "src/scenes/scene.hpp"

namespace sphk {

/// Where and with what a run computes.
struct Platform {
  std::string backend;  ///< Kokkos' execution space: OpenMP, Serial, Cuda, HIP
  std::string device;   ///< the processor or the accelerator
  int threads = 1;      ///< of the execution space
  std::string precision;
  double fma_peak = 0;  ///< measured, in the pair arithmetic's precision, operations per second of all threads
};

/// Which sphk computes.
struct Build {
  std::string version, git_revision, compiler;
  std::string flags, kokkos;  ///< of the compiler; Kokkos' version and backends
};

/// Who started a run, where and when.
struct Provenance {
  std::string command, host;
  std::string date;  ///< of the start, or of the last resume: 2026-01-31T12:00:00Z
};

/// Everything that run.json and the final table say about a run.
struct RunRecord {
  std::string scene, scheme, kernel;
  double neighbours = 0;
  std::int64_t n = 0;  ///< particles along the box; 0 for an initial-condition file
  std::size_t particles = 0;
  int dimension = 3;
  Platform platform;
  Build build;
  Provenance provenance;
  long steps = 0;
  double time = 0;          ///< reached, in code units
  bool finished = false;    ///< the end time or the asked number of steps was reached
  double wall_seconds = 0;  ///< of the time loop alone
  double cpu_seconds = 0;   ///< of the time loop alone, all threads
  double setup_seconds = 0, output_seconds = 0;
  std::optional<double> joules;  ///< of the processors during the time loop, where the machine tells
  double peak_memory_bytes = 0;  ///< that the process held
  Costs costs;
  Counts counts;
  Conservation conservation;
  std::map<std::string, ErrorNorm> errors;
  std::map<std::string, Deviation> deviations;  ///< of the measures from converged runs
  std::optional<ErrorBudget> budget;            ///< at the last output, where it was asked for
  std::vector<std::string> left_out, warnings;

  double updates_per_second() const { return wall_seconds > 0 ? static_cast<double>(costs.updates) / wall_seconds : 0; }
  double pairs_per_second() const { return wall_seconds > 0 ? costs.pair_interactions / wall_seconds : 0; }
  double flops_per_second() const { return wall_seconds > 0 ? costs.flops / wall_seconds : 0; }
  double share_of_peak() const { return platform.fma_peak > 0 ? flops_per_second() / platform.fma_peak : 0; }
};

}  // namespace sphk
