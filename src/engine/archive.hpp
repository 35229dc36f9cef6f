// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <Kokkos_Core.hpp>
#include <cstring>
#include <type_traits>

#include "src/engine/errors.hpp"
#include "src/engine/saved_state.hpp"

namespace sphk {

/// Hands numbers, vectors of numbers and views over as blocks of bytes.
class StateWriter {
 public:
  explicit StateWriter(const TakeBlock& take) : take_(take) {}

  template <class T>
  void operator()(const std::string& name, const T& value) {
    if constexpr (Kokkos::is_view_v<T>) {
      const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, value);
      put(name, host.data(), host.span() * sizeof(typename T::value_type));
    } else if constexpr (std::is_trivially_copyable_v<T>) {
      put(name, &value, sizeof(T));
    } else {
      put(name, value.data(), value.size() * sizeof(typename T::value_type));
    }
  }

 private:
  void put(const std::string& name, const void* data, std::size_t bytes) {
    take_(name, {static_cast<const std::uint8_t*>(data), bytes});
  }
  const TakeBlock& take_;
};

/// Takes them in again. Throws InputError where a block is missing or has another size.
class StateReader {
 public:
  explicit StateReader(const GiveBlock& give) : give_(give) {}

  template <class T>
  void operator()(const std::string& name, T& value) {
    const std::vector<std::uint8_t> block = give_(name);
    if constexpr (Kokkos::is_view_v<T>) {
      const auto host = Kokkos::create_mirror_view(Kokkos::HostSpace{}, value);
      get(name, block, host.data(), host.span() * sizeof(typename T::value_type));
      Kokkos::deep_copy(value, host);
    } else if constexpr (std::is_trivially_copyable_v<T>) {
      get(name, block, &value, sizeof(T));
    } else {
      value.resize(block.size() / sizeof(typename T::value_type));
      get(name, block, value.data(), value.size() * sizeof(typename T::value_type));
    }
  }

 private:
  static void get(const std::string& name, const std::vector<std::uint8_t>& block, void* data, std::size_t bytes) {
    if (block.size() != bytes)
      throw InputError(
          fmt::format("the saved state's \"{}\" has {} bytes, {} are wanted: it is of another scheme, "
                      "number of particles or build",
                      name, block.size(), bytes));
    if (bytes > 0) std::memcpy(data, block.data(), bytes);
  }
  const GiveBlock& give_;
};

}  // namespace sphk
