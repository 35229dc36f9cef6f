// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The whole library: particles, settings, schemes, scenes, files, runs. The smoothing kernels and terms, for code that
/// builds schemes of its own, are under "kernels/".

#include "src/engine/particle_set.hpp"
#include "src/engine/settings.hpp"
#include "src/engine/simulation.hpp"
#include "src/io/reader.hpp"
#include "src/io/snapshot_writer.hpp"
#include "src/run/rates.hpp"
#include "src/run/run.hpp"
#include "src/scenes/scene.hpp"
#include "src/schemes/registry.hpp"
