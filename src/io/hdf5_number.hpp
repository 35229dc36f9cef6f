// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hdf5.h>

namespace sphk::hdf5 {

/// Whether values of this type can be had as numbers: integers of 1 to 8 bytes, enumerations of such (booleans), and
/// reals of up to 16 bytes, in either byte order and with any sound choice of their bits: half precision, bfloat16 and
/// the shortened mantissas of lossy filters among them. HDF5 1.10 writes past its own stack when a damaged file makes
/// it convert from a type with absurd bit fields.
bool is_number(hid_t type);

}  // namespace sphk::hdf5
