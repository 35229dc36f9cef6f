// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>
#include <cstdint>

#include "kernels/core/columns.hpp"

namespace sphk {

/// Times of a hierarchy of steps, in ticks since the start of a block of time.
using Ticks = std::int64_t;

/// How far a run has got: one step for all particles, or steps of their own that are powers of two of a tick. A block
/// of time, at whose end all steps end, is 2^block_bits ticks long.
struct StepClock {
  static constexpr int block_bits = 44;
  static constexpr Ticks block = Ticks(1) << block_bits;

  double dt = 0;        ///< length of the drift in progress
  double mobility = 1;  ///< 0: particles keep their places and velocities
  bool individual = false;
  double tick = 0;
  Ticks now = 0, next = 0;                       ///< where the drift in progress begins and ends
  Kokkos::View<Ticks*, MemorySpace> begin, end;  ///< of every particle's step; empty where one step serves all
  /// Its nominal step is 2^power ticks; that in progress is shorter where it began between multiples of them.
  Kokkos::View<std::uint8_t*, MemorySpace> power;
  /// Of every cell: for how long its particles have moved without anything else of them having been predicted.
  Kokkos::View<double*, MemorySpace> late;

  /// Does a step of particle i begin where the drift does?
  KOKKOS_INLINE_FUNCTION bool opens(int i) const { return !individual || begin(i) == now; }
  KOKKOS_INLINE_FUNCTION double late_of(int cell) const { return individual ? late(cell) : 0; }
  /// The particle's own step, as a time.
  KOKKOS_INLINE_FUNCTION double step_of(int i) const {
    return individual ? static_cast<double>(end(i) - begin(i)) * tick : dt;
  }
};

}  // namespace sphk
