#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "src/run/problem.hpp"

namespace sphk {

/// A snapshot as the drawing scripts take it: where the particles are, what to draw around them, and the exact solution
/// where `exact` asks for it. Without the problem it is drawn plainly.
nlohmann::ordered_json describe_snapshot(const std::filesystem::path& snapshot, const std::optional<Problem>& problem,
                                         bool exact);

}  // namespace sphk
