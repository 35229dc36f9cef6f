// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace sphk {

/// The user asked for something that cannot be done (exit code 2). The message says what, where and how to mend it.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The numbers went wrong during a run: NaN, negative energy, a vanishing time-step (exit code 3).
struct NumericsError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace sphk
