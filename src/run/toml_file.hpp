// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <toml.hpp>

namespace sphk {

/// Parses a TOML file; `what` it is ("scene file") is for the message when it cannot be read. What toml11 does not
/// survive is refused before it sees it: bytes that are no UTF-8, and brackets or dotted names nested without end.
/// Throws InputError with file and line.
toml::value parse_toml(const std::filesystem::path& path, const std::string& what);
/// The same of a text; `name` is that of its file.
toml::value parse_toml_text(const std::string& text, const std::string& name);
/// The text of such a file. Throws InputError where it cannot be read.
std::string read_toml_file(const std::filesystem::path& path, const std::string& what);

}  // namespace sphk
