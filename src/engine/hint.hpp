// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace sphk {

/// The end of a sentence on an unknown name: the known one that is near it, or what to do where none is.
inline std::string hint(const std::string& nearest, const std::string& otherwise) {
  return nearest.empty() ? otherwise : "did you mean \"" + nearest + "\"?";
}

}  // namespace sphk
