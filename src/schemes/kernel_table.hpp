// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kernels/smoothing/tabulated.hpp"

namespace sphk {

/// The table of the smoothing kernel of that name, made in one source file for all schemes. Throws
/// std::invalid_argument with the known names.
Tabulated kernel_table(const std::string& name);

}  // namespace sphk
