// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "src/run/problem.hpp"

namespace sphk {

/// What a run would cost, from a trial of a few steps.
struct DryRun {
  std::string scene, scheme, kernel, precision;
  double neighbours = 0;
  double particles = 0;
  int dimension = 3, trial_steps = 0;
  std::size_t trial_particles = 0;  ///< as many were tried; fewer than all where those are many
  double bytes_per_particle = 0;    ///< on the device
  double peak_bytes = 0;            ///< of memory that the run will hold, outputs included
  double available_bytes = 0;       ///< that this machine can give
  double dt = 0, end = 0;           ///< the time-step after the trial, the end time; code units
  double steps = 0;                 ///< to the end, if the time-step stays as it is
  double snapshots = 0, output_bytes = 0;
  double seconds_per_step = 0;

  double seconds() const { return steps * seconds_per_step; }
  /// For people, in lines; and {"dry_run": {...}} on one line.
  std::string text() const;
  std::string json() const;
};

/// Takes a trial of three steps, with fewer particles where they are many, and writes nothing. Kokkos must be
/// running.
DryRun dry_run(const Problem& problem);

/// Seconds of a run to its end on all cores of this machine, from numbers of particles, steps and neighbours alone.
/// Good to a factor of a few.
double rough_seconds(const ParticleSet& particles, const Settings& settings);

}  // namespace sphk
