// SPDX-License-Identifier: BSD-3-Clause

// What own_scheme.hpp defines, for the command line: sphk run standing-wave --scheme rubbing --module libown_module.so
#include <sphk_module.hpp>

#include "own_scheme.hpp"

static const StandingWave standing_wave;

extern "C" void sphk_module(Module& mine) {
  mine.add_kernel<Cubed>();
  mine.add_scheme<Rubbing>();
  mine.add_scene(standing_wave);
}
