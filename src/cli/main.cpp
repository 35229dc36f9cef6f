// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <Kokkos_Core.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <optional>
#include <string_view>

#include "src/cli/command_line.hpp"
#include "src/report/print.hpp"
#include "src/run/failure.hpp"
#include "src/run/kokkos_start.hpp"

namespace {

int perform(int argc, char** argv) {
  const sphk::Request request = sphk::parse_command_line(argc, argv);
  std::optional<Kokkos::ScopeGuard> kokkos;
  if (request.computes) kokkos.emplace(sphk::kokkos_settings(request.threads));
  return request.act();
}

/// A file must not take the place of standard output that the user has closed, and get what is printed.
void open_standard_streams() {
  int file = 0;
  while (file >= 0 && file <= STDERR_FILENO) file = open("/dev/null", O_RDWR);
  if (file > STDERR_FILENO) close(file);
}

/// Large arrays go back to the system when they are freed: glibc would keep ever larger ones for itself.
void return_large_arrays() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
}

/// Does the command line ask for JSON alone? Where it cannot be read as well.
bool wants_json(int argc, char** argv) {
  return std::any_of(argv, argv + argc, [](const char* word) { return std::string_view(word) == "--json-log"; });
}

}  // namespace

int main(int argc, char** argv) {
  open_standard_streams();
  return_large_arrays();
  std::signal(SIGXFSZ, SIG_IGN);  // a file over the user's limit is then an error of its write, with a sentence
  try {
    return perform(argc, argv);
  } catch (...) {
    const sphk::Failure failure = sphk::current_failure();
    if (wants_json(argc, argv)) {
      sphk::print_if_possible(stdout, failure.json() + "\n");
    } else {
      std::fflush(stdout);
      sphk::print_if_possible(stderr, "error: " + failure.message + "\n");
    }
    return failure.exit_code;
  }
}
