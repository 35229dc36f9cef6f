// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/failure.hpp"

#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <new>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include "src/engine/errors.hpp"

namespace sphk {

namespace {

constexpr const char* remedy =
    "out of memory{}; take fewer particles (-n), or ask `sphk run ... --dry-run` what is needed";

/// Kokkos throws a plain std::runtime_error where memory is short, on hosts and devices alike.
bool is_of_memory(std::string_view message) {
  return message.find("memory space failed to allocate") != std::string_view::npos;
}

}  // namespace

Failure current_failure() {
  try {
    throw;
  } catch (const InputError& error) {
    return {ExitCode::bad_input, error.what()};
  } catch (const NumericsError& error) {
    return {ExitCode::numerics, error.what()};
  } catch (const std::invalid_argument& error) {  // an unknown smoothing kernel
    return {ExitCode::bad_input, error.what()};
  } catch (const std::filesystem::filesystem_error& error) {
    return {ExitCode::bad_input, error.what()};
  } catch (const std::bad_alloc&) {
    return {ExitCode::device, fmt::format(remedy, "")};
  } catch (const std::exception& error) {  // what Kokkos and its devices throw
    const std::string_view message = error.what();
    if (!is_of_memory(message)) return {ExitCode::device, error.what()};
    return {ExitCode::device, fmt::format(remedy, fmt::format(" ({})", message.substr(0, message.find('\n'))))};
  }
}

std::string Failure::json() const {
  using Json = nlohmann::ordered_json;
  return Json{{"error", message}, {"exit_code", exit_code}}.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace sphk
