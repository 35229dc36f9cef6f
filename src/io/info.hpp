#pragma once

#include <filesystem>
#include <string>

namespace sphk {

/// The text of `sphk info FILE`: what kind of file it is, time, units, dimension, box, scheme, gamma, the number of
/// particles of every type, and least, mean and largest value of each gas field. Throws InputError when it is no
/// readable HDF5 file.
std::string file_info(const std::filesystem::path& path);

}  // namespace sphk
