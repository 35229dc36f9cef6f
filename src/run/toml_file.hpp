#pragma once

#include <filesystem>
#include <string>
#include <toml.hpp>

namespace sphk {

/// Parses a TOML file; `what` it is ("scene file") is for the message when it cannot be read. What toml11 does not
/// survive is refused before it sees it: bytes that are no UTF-8, and brackets or dotted names nested without end.
/// Throws InputError with file and line.
toml::value parse_toml(const std::filesystem::path& path, const std::string& what);

}  // namespace sphk
