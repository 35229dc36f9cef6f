// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string_view>
#include <utility>

namespace sphk {

/// Prints what can be printed: a reader that has gone, a closed terminal or a full disk is no reason to lose a run.
inline void print_if_possible(std::FILE* out, std::string_view text) {
  [[maybe_unused]] const std::size_t written = std::fwrite(text.data(), 1, text.size(), out);
}

/// The same for formatted text on standard output, told at once.
template <class... Values>
void say(fmt::format_string<Values...> text, Values&&... values) {
  print_if_possible(stdout, fmt::format(text, std::forward<Values>(values)...));
  std::fflush(stdout);
}

}  // namespace sphk
