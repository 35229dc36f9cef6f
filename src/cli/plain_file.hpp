#pragma once

#include <filesystem>

#include "src/engine/particle_set.hpp"

namespace sphk {

/// Writes gas as other codes do, with SWIFT's names and no group of sphk's own; h where there is one, ids from 1 where
/// there are none. The box begins at 0; all of its axes are periodic, or none.
void write_plain_file(const std::filesystem::path& path, const ParticleSet& gas);

}  // namespace sphk
