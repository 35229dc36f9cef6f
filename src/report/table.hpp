// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace sphk {

/// Words and numbers in columns, for a terminal or a page.
struct Table {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows{};  ///< each as long as the head
  std::vector<std::size_t> words{0};             ///< columns that are set flush left; numbers are set flush right

  /// Lines that begin with two spaces; columns two apart.
  std::string text() const;
};

}  // namespace sphk
