// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

#include "src/schemes/scheme_facts.hpp"

namespace sphk {

/// A scheme as command line, files and studies know it, whether or not any of it is compiled.
struct SchemeEntry {
  const SchemeFacts* facts;
  std::vector<const char*> energies;   ///< the thermal variables that it integrates, the default first
  std::vector<const Number*> numbers;  ///< of its terms and passes, one of each key

  bool integrates(std::string_view energy) const {
    return std::ranges::any_of(energies, [&](const char* own) { return own == energy; });
  }
  /// Its number of that key, or null.
  const Number* number(std::string_view key) const {
    const auto own = std::ranges::find_if(numbers, [&](const Number* n) { return n->key == key; });
    return own == numbers.end() ? nullptr : *own;
  }
};
using Catalogue = std::vector<SchemeEntry>;

}  // namespace sphk
