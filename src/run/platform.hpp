// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "src/report/run_record.hpp"

namespace sphk {

/// The default execution space and its measured FMA peak for a precision ("mixed", "double"). Kokkos must be running.
Platform detect_platform(const std::string& precision);

Build build();

/// This process, host and time.
Provenance provenance();

/// "sphk 0.1.0 (revision), compiler, Kokkos".
std::string version_text();

}  // namespace sphk
