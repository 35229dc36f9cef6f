// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace sphk {

/// What the user asked for, ready to be done.
struct Request {
  std::function<int()> act;  ///< returns the exit code
  bool computes = false;     ///< needs Kokkos
  int threads = 0;           ///< 0: as many as the backend chooses
};

/// Reads the command line. --help and --version become requests that print. Throws InputError that names the wrong
/// argument, the nearest option where there is one, and the help to read.
Request parse_command_line(int argc, char** argv);

}  // namespace sphk
