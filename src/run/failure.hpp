// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace sphk {

/// Exit codes of sphk; scripts rely on them.
struct ExitCode {
  static constexpr int done = 0, bad_input = 2, numerics = 3, device = 4, stopped = 75;
};

/// What a user is told of an exception.
struct Failure {
  int exit_code = ExitCode::device;
  std::string message;

  /// {"error": message, "exit_code": exit_code}, as a run's JSON log ends with.
  std::string json() const;
};

/// Of the exception that is being handled: to be called in a `catch`. What fails to be allocated is told with the way
/// to ask for less, whether the standard library or Kokkos says so.
Failure current_failure();

}  // namespace sphk
