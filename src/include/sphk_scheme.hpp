// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What a scheme, a term, a smoothing kernel or a scene of one's own needs beside <sphk.hpp>
/// (docs/examples/own_scheme.hpp).

#include <sphk.hpp>

#include "kernels/smoothing/list.hpp"
#include "kernels/terms/pressure_gradient_sph.hpp"
#include "kernels/terms/signal_velocity.hpp"
#include "src/scenes/keys.hpp"
#include "src/schemes/make_simulation.hpp"
#include "src/schemes/step.hpp"
