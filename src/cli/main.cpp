#include <fmt/format.h>

#include <Kokkos_Core.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <optional>
#include <string_view>

#include "src/cli/command_line.hpp"
#include "src/run/failure.hpp"

namespace {

int perform(int argc, char** argv) {
  const sphk::Request request = sphk::parse_command_line(argc, argv);
  std::optional<Kokkos::ScopeGuard> kokkos;
  if (request.computes) {
    Kokkos::InitializationSettings settings;
    settings.set_disable_warnings(true);
    if (request.threads > 0) settings.set_num_threads(request.threads);
    kokkos.emplace(settings);
  }
  return request.act();
}

/// Does the command line ask for JSON alone? Where it cannot be read as well.
bool wants_json(int argc, char** argv) {
  return std::any_of(argv, argv + argc, [](const char* word) { return std::string_view(word) == "--json-log"; });
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file over the user's limit is then an error of its write, with a sentence
  try {
    return perform(argc, argv);
  } catch (...) {
    const sphk::Failure failure = sphk::current_failure();
    if (wants_json(argc, argv)) {
      fmt::print("{}\n", failure.json());
    } else {
      std::fflush(stdout);
      fmt::print(stderr, "error: {}\n", failure.message);
    }
    return failure.exit_code;
  }
}
