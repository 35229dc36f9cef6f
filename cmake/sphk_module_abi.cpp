// SPDX-License-Identifier: BSD-3-Clause
#include <sphk_abi.hpp>

/// Linked to every module (src/schemes/shared_object.cpp).
extern "C" const char sphk_abi[] = SPHK_ABI;
