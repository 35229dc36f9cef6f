// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "src/schemes/catalogue.hpp"
#include "src/schemes/instantiation.hpp"

namespace sphk {

/// The schemes of this build, by the list in CMakeLists.txt, which writes this function.
Catalogue catalogue_of_build();

/// The compiled recipes of one of them: linked to the program (CMakeLists.txt writes this function then), or in a
/// shared object, which is loaded, and in a build folder compiled where it is not there or of older headers
/// (loaded_rows.cpp). Throws InputError where it cannot be had.
Instantiations rows_of_build(const std::string& scheme, int dimension);

}  // namespace sphk
