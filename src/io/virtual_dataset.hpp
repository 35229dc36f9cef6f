// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/io/hdf5_file.hpp"

namespace sphk::hdf5 {

/// Throws InputError unless every row of a virtual dataset, whose data lie in other files, is there: HDF5 itself fills
/// what it does not find with zeros. Names the part that is missing, and where it was looked for.
void require_parts(const Dataset& dataset);

}  // namespace sphk::hdf5
