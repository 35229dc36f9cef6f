// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/kokkos_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "src/engine/errors.hpp"
#include "src/report/print.hpp"

#if defined(KOKKOS_ENABLE_OPENMP)
#include <omp.h>
#endif

namespace sphk {

namespace {

std::optional<std::string> variable(const char* name) {
  const char* text = std::getenv(name);
  return text ? std::optional<std::string>(text) : std::nullopt;
}

void refuse(const char* name, const std::string& text, const std::string& wanted) {
  throw InputError(
      fmt::format("{}={} in the environment: {} is wanted; correct it, or unset {}", name, text, wanted, name));
}

/// The integer that a variable holds, where it is set.
std::optional<int> integer(const char* name, int least) {
  const auto text = variable(name);
  if (!text) return std::nullopt;
  int value = 0;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
  if (error != std::errc{} || end != text->data() + text->size() || value < least)
    refuse(name, *text, fmt::format("an integer of {} or more", least));
  return value;
}

void require_one_of(const char* name, std::initializer_list<std::string_view> known) {
  auto text = variable(name);
  if (!text) return;
  const std::string given = *text;
  std::ranges::transform(*text, text->begin(), [](unsigned char c) { return std::tolower(c); });
  if (std::ranges::find(known, std::string_view(*text)) == known.end())
    refuse(name, given, fmt::format("one of {}", fmt::join(known, ", ")));
}

/// As many threads as OpenMP may start, where it does: Kokkos keeps a pool of that size.
int limited(int threads) {
#if defined(KOKKOS_ENABLE_OPENMP)
  constexpr int most = Kokkos::Impl::OpenMPTraits::MAX_THREAD_COUNT;
  const int asked = threads > 0 ? threads : omp_get_max_threads();
  if (asked > most) {
    print_if_possible(
        stderr, fmt::format("note: {} threads are asked for; {} are used, the most that Kokkos takes\n", asked, most));
    threads = most;
  }
  if (omp_get_max_threads() > most) omp_set_num_threads(most);  // Kokkos starts them all to count them
#endif
  return threads;
}

}  // namespace

Kokkos::InitializationSettings kokkos_settings(int threads) {
  const std::optional<int> of_environment = integer("KOKKOS_NUM_THREADS", 1);
  integer("KOKKOS_DEVICE_ID", 0);
  for (const char* name :
       {"KOKKOS_DISABLE_WARNINGS", "KOKKOS_PRINT_CONFIGURATION", "KOKKOS_TUNE_INTERNALS", "KOKKOS_TOOLS_GLOBALFENCES"})
    require_one_of(name, {"true", "false", "yes", "no", "1", "0"});
  require_one_of("KOKKOS_MAP_DEVICE_ID_BY", {"mpi_rank", "random"});
  Kokkos::InitializationSettings settings;
  settings.set_disable_warnings(true);
  if (const int used = limited(threads > 0 ? threads : of_environment.value_or(0)); used > 0)
    settings.set_num_threads(used);
  return settings;
}

}  // namespace sphk
