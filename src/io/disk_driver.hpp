// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#define H5_USE_110_API
#include <hdf5.h>

namespace sphk::hdf5 {

/// Where a new HDF5 file goes, and how that went.
struct Target {
  int file = -1;              ///< open for reading and writing
  bool drops_values = false;  ///< what datasets hold is not written: the file is made for its size alone
  int error = 0;              ///< errno of the first write that failed
};

/// A file access list for H5Fcreate that puts the new file into `target`. HDF5 hears of no failure: after one that 1.10
/// hears of it can neither close its file nor let the program end without a crash. Who wants the file asks `target`.
hid_t access_to(Target& target);

}  // namespace sphk::hdf5
