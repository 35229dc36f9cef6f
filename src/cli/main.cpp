#include <fmt/format.h>

#include <Kokkos_Core.hpp>
#include <csignal>
#include <cstdio>
#include <new>
#include <optional>

#include "src/cli/command_line.hpp"
#include "src/cli/commands.hpp"
#include "src/engine/errors.hpp"

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

int fail(int code, const char* message) {
  std::fflush(stdout);
  fmt::print(stderr, "error: {}\n", message);
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  using sphk::ExitCode;
  std::signal(SIGXFSZ, SIG_IGN);  // a file over the user's limit is then an error of its write, with a sentence
  try {
    return perform(argc, argv);
  } catch (const sphk::InputError& error) {
    return fail(ExitCode::bad_input, error.what());
  } catch (const sphk::NumericsError& error) {
    return fail(ExitCode::numerics, error.what());
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::device,
                "out of memory; take fewer particles (-n) or ask `sphk run ... --dry-run` what is needed");
  } catch (const std::exception& error) {  // DeviceError, and what Kokkos and HDF5 throw
    return fail(ExitCode::device, error.what());
  }
}
