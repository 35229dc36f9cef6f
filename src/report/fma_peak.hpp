// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace sphk {

/// Floating-point operations per second of fused multiply-adds (2 operations each) in float and in double, all threads
/// of the default execution space at once.
struct FmaPeak {
  double single = 0;
  double twofold = 0;
  /// The peak of the pair arithmetic of a precision: "mixed" (float pairs) or "double".
  double of(std::string_view precision) const { return precision == "double" ? twofold : single; }
};

/// Measures the peak with register-only loops, in about 20 ms per number type. Kokkos must be running.
FmaPeak measure_fma_peak();

}  // namespace sphk
