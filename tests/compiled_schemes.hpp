// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>

#include "src/schemes/registry.hpp"

namespace sphk {

/// Whether this build has a scheme: SPHK_SCHEMES may leave some out. Tests of the others skip themselves.
inline bool is_compiled(const std::string& scheme) {
  const std::vector<std::string> names = scheme_names();
  return std::ranges::find(names, scheme) != names.end();
}

}  // namespace sphk
