// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace sphk {

/// A number of things with a decimal prefix and three significant digits: 512 k, 1.23 M, 94.1 G; nothing below 1000.
std::string with_prefix(double number);
/// Bytes in B, KiB, MiB, GiB or TiB.
std::string bytes_text(double bytes);
/// A duration as people say it: 0.42 s, 12 s, 3:07, 2:05:09 (hours:minutes:seconds).
std::string duration_text(double seconds);

}  // namespace sphk
