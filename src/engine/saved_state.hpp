// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace sphk {

/// Everything that a run's next step depends on, bit by bit, in named blocks of bytes; means something to the scheme,
/// particle number and build that it comes from.
using SavedState = std::map<std::string, std::vector<std::uint8_t>>;

/// Gives the block of a saved state that has this name; throws InputError where there is none.
using GiveBlock = std::function<std::vector<std::uint8_t>(const std::string& name)>;
/// Takes the blocks of a saved state, one after the other.
using TakeBlock = std::function<void(const std::string& name, std::span<const std::uint8_t> bytes)>;

}  // namespace sphk
