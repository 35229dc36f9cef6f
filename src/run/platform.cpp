// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/platform.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <Kokkos_Core.hpp>
#include <ctime>
#include <sphk_version.hpp>
#include <type_traits>

#include "src/report/fma_peak.hpp"
#include "src/report/machine.hpp"
#include "src/report/process.hpp"

namespace sphk {

namespace {

using Space = Kokkos::DefaultExecutionSpace;

std::string device_name() {
#if defined(KOKKOS_ENABLE_CUDA) || defined(KOKKOS_ENABLE_HIP)
  if constexpr (!std::is_same_v<Space, Kokkos::DefaultHostExecutionSpace>)
#if defined(KOKKOS_ENABLE_CUDA)
    return Kokkos::Cuda().cuda_device_prop().name;
#else
    return Kokkos::HIP().hip_device_prop().name;
#endif
#endif
  return machine_name();
}

}  // namespace

Platform detect_platform(const std::string& precision) {
  return {.backend = Space::name(),
          .device = device_name(),
          .threads = Space().concurrency(),
          .precision = precision,
          .fma_peak = measure_fma_peak().of(precision)};
}

Build build() {
  return {.version = build_info::version,
          .git_revision = build_info::git_revision,
          .compiler = fmt::format("{} {}", build_info::compiler_name, build_info::compiler_version),
          .flags = SPHK_COMPILER_FLAGS,
          .kokkos = fmt::format("{} for {}", build_info::kokkos_version, build_info::kokkos_backends)};
}

Provenance provenance() {
  const std::time_t now = std::time(nullptr);
  return {.command = command_of_this_process(),
          .host = host_name(),
          .date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now))};
}

std::string version_text() {
  return fmt::format("sphk {} ({}), {} {} {}, Kokkos {} for {}", build_info::version, build_info::git_revision,
                     build_info::compiler_name, build_info::compiler_version, build_info::build_type,
                     build_info::kokkos_version, build_info::kokkos_backends);
}

}  // namespace sphk
