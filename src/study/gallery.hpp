// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/study/child.hpp"

namespace sphk {

/// A small run of every scene, and one page with them all: index.html and gallery.png in the
/// folder. Tells on standard output how far it is. Returns whether every run came to its end; a signal stops it
/// (stop_signal.hpp), without a page. Throws InputError.
bool make_gallery(const Batch& batch);

}  // namespace sphk
