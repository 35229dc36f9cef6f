// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>

namespace sphk {

/// How Kokkos is to be started: quietly, and with so many threads on the CPU (0: as OpenMP or KOKKOS_NUM_THREADS say),
/// but no more than it takes, which a note on standard error tells. Throws InputError where a variable of the
/// environment has a value at which Kokkos would end the program.
Kokkos::InitializationSettings kokkos_settings(int threads);

}  // namespace sphk
