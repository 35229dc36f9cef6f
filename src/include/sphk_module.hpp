// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What a module of one's own includes: a shared object with a scheme, smoothing kernel, term or scene, which every
/// command loads (--module FILE, SPHK_MODULE_PATH; docs/examples/own_module.cpp).

#include <sphk_abi.hpp>
#include <sphk_scheme.hpp>

#include "src/schemes/module.hpp"

/// The headers that the module was compiled against.
extern "C" [[gnu::weak, gnu::used]] const char sphk_abi[] = SPHK_ABI;
