#pragma once

#include <filesystem>
#include <string>

#include "src/report/run_record.hpp"

namespace sphk {

/// The default execution space and its measured FMA peak for a precision ("mixed", "double"). Kokkos must be running.
Platform detect_platform(const std::string& precision);

Build build();

/// share/sphk beside the folder of this executable, in the build tree and where it is installed: the drawing scripts
/// and the studies that have names.
std::filesystem::path shared_folder();

/// "sphk 0.1.0 (revision), compiler, Kokkos".
std::string version_text();

}  // namespace sphk
