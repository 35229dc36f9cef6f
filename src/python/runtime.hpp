// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <mutex>

namespace sphk::python {

/// Starts Kokkos, once a process, with so many threads (0: as OpenMP or KOKKOS_NUM_THREADS say). Throws InputError
/// where it runs with another number already.
void require_engine(int threads = 0);

/// One call computes at a time, whatever Python's threads do. To be taken without the interpreter's lock.
std::mutex& engine_mutex();

/// What is to be closed before Kokkos ends: runs register how. Returns a handle that takes it back when it goes.
std::shared_ptr<void> closed_at_exit(std::function<void()> close);

/// Keeps memory for as long as an array shows it. At the end of the process Python's arrays may outlive Kokkos: what
/// they show is then left to the system.
struct KeptMemory {
  std::shared_ptr<const void> memory;
  ~KeptMemory();
};

/// Closes all that is registered, and ends Kokkos: to be called once, before the interpreter goes.
void end_engine();

}  // namespace sphk::python
