// SPDX-License-Identifier: BSD-3-Clause
#include "src/python/runtime.hpp"

#include <fmt/format.h>

#include <Kokkos_Core.hpp>
#include <list>

#include "src/engine/errors.hpp"
#include "src/run/kokkos_start.hpp"

namespace sphk::python {

namespace {

using Closers = std::list<std::function<void()>>;

Closers& closers() {
  static auto* const all = new Closers;  // Python may drop its last runs after static objects have gone
  return *all;
}

}  // namespace

void require_engine(int threads) {
  if (Kokkos::is_finalized()) throw InputError("Python is ending: nothing is computed any more");
  if (!Kokkos::is_initialized()) return Kokkos::initialize(kokkos_settings(threads));
  const int running = Kokkos::DefaultHostExecutionSpace().concurrency();
  if (threads > 0 && threads != running)
    throw InputError(fmt::format(
        "threads = {}: this process computes with {} already, as its first simulation asked; set the number "
        "there, or start Python anew",
        threads, running));
}

std::mutex& engine_mutex() {
  static auto* const mutex = new std::mutex;
  return *mutex;
}

std::shared_ptr<void> closed_at_exit(std::function<void()> close) {
  const auto place = closers().insert(closers().end(), std::move(close));
  return {nullptr, [place](void*) { closers().erase(place); }};
}

KeptMemory::~KeptMemory() {
  const std::scoped_lock alone(engine_mutex());
  if (Kokkos::is_finalized())
    new std::shared_ptr<const void>(std::move(memory));
  else
    memory.reset();
}

void end_engine() {
  for (const auto& close : closers()) close();
  if (Kokkos::is_initialized()) Kokkos::finalize();
}

}  // namespace sphk::python
