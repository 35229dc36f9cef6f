// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "src/engine/particle_set.hpp"

namespace sphk {

/// What else there is to say of gas that a run can start from.
using GasRemarks = std::function<std::vector<std::string>(const ParticleSet&)>;

/// The text of `sphk info FILE`: what kind of file it is, time, units, dimension, box, scheme, gamma, the number of
/// particles of every type, and least, mean and largest value of each gas field. Throws InputError when it is no
/// readable HDF5 file.
std::string file_info(const std::filesystem::path& path, const GasRemarks& remarks = {});

}  // namespace sphk
