// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/quantity.hpp"

#include <fmt/format.h>

#include <cmath>

namespace sphk {

namespace {

/// Three significant digits, without an exponent.
std::string three_digits(double number) {
  const double size = std::abs(number);
  return fmt::format("{:.{}f}", number, size < 9.995 ? 2 : size < 99.95 ? 1 : 0);
}

}  // namespace

std::string with_prefix(double number) {
  const char* prefix[] = {"k", "M", "G", "T", "P"};
  if (std::abs(number) < 1000) return fmt::format("{:.3g}", number);
  int step = -1;
  while (std::abs(number) >= 999.5 && step < 4) number /= 1000, ++step;
  return fmt::format("{} {}", three_digits(number), prefix[step]);
}

std::string bytes_text(double bytes) {
  const char* unit[] = {"B", "KiB", "MiB", "GiB", "TiB"};
  int step = 0;
  while (std::abs(bytes) >= 1023.5 && step < 4) bytes /= 1024, ++step;
  return step == 0 ? fmt::format("{:.0f} B", bytes) : fmt::format("{} {}", three_digits(bytes), unit[step]);
}

std::string duration_text(double seconds) {
  if (!std::isfinite(seconds)) return "unknown";
  if (seconds < 59.5) return fmt::format("{:.{}f} s", seconds, seconds < 9.95 ? 2 : 0);
  const auto total = static_cast<long long>(std::lround(seconds));
  if (total < 3600) return fmt::format("{}:{:02}", total / 60, total % 60);
  return fmt::format("{}:{:02}:{:02}", total / 3600, total / 60 % 60, total % 60);
}

}  // namespace sphk
