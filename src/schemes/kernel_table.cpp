// SPDX-License-Identifier: BSD-3-Clause
#include "src/schemes/kernel_table.hpp"

#include "kernels/smoothing/list.hpp"

namespace sphk {

Tabulated kernel_table(const std::string& name) {
  return with_kernel(name, [&](const auto& kernel) { return Tabulated(kernel, name); });
}

}  // namespace sphk
