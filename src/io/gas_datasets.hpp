// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>

#include "src/engine/particle_set.hpp"
#include "src/io/hdf5_file.hpp"
#include "src/io/reader.hpp"

namespace sphk {

/// Most gas particles of a file set: a run counts them in 32 bits.
inline constexpr std::int64_t most_particles = std::numeric_limits<std::int32_t>::max();

/// Adds the particles of a PartType0 group, under whichever names and shapes, to `gas`; its dimension becomes the
/// number of components per row of Coordinates. `table_mass` stands in for missing Masses when it is positive; h, alpha
/// and id may be missing. Throws InputError on missing datasets, wrong types, shapes that disagree and, with
/// NonFinite::refuse, on NaN and infinities.
void add_gas(ParticleSet& gas, const hdf5::Group& group, double table_mass, NonFinite non_finite);

}  // namespace sphk
