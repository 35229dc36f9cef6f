// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/study/child.hpp"

namespace sphk {

/// Runs the cases that are named, of the files (*.toml) that are or of those that come with sphk, and tells on standard
/// output and in the folder's extremes.txt what is required of each and what came out. Returns whether all kept within
/// their bounds; a signal stops it (stop_signal.hpp), without a table. Throws InputError, before anything runs, for
/// cases that are none.
bool make_extremes(const Batch& batch);

}  // namespace sphk
