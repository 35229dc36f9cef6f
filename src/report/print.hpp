#pragma once

#include <cstdio>
#include <string_view>

namespace sphk {

/// Prints what can be printed: a reader that has gone, a closed terminal or a full disk is no reason to lose a run.
inline void print_if_possible(std::FILE* out, std::string_view text) {
  [[maybe_unused]] const std::size_t written = std::fwrite(text.data(), 1, text.size(), out);
}

}  // namespace sphk
