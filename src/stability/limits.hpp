// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "src/stability/contrasts.hpp"

namespace sphk {

/// What computes; an empty scheme: any may.
struct Method {
  std::string scheme, energy;
  std::string signal{};  ///< of the conductivity; empty: none
  bool motion = true;    ///< particles move
};

/// Sentences on the known limits that the gas meets under the method: what happens to such gas, and what copes with it.
std::vector<std::string> limit_remarks(const Contrasts& gas, const Method& method);

}  // namespace sphk
