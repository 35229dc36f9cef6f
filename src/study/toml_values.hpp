// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <toml.hpp>
#include <utility>
#include <vector>

namespace sphk {

/// Throws InputError: the problem, the line of `value` with a caret below it, and what is wanted there.
[[noreturn]] void refuse(const toml::value& value, const std::string& problem, const std::string& comment);

/// The value of a key as --set would take it.
std::string text_of(const toml::value& value);
std::string string_of(const toml::value& value);
double number_of(const toml::value& value);
double positive_number_of(const toml::value& value);

/// A table's keys with their values, sections and all ("sph.kernel"), in the order of the file.
std::vector<std::pair<std::string, toml::value>> keys_of(const toml::value& table, const std::string& prefix = "");

/// TOML files of a folder by their names.
std::vector<std::filesystem::path> toml_files_in(const std::filesystem::path& folder);

}  // namespace sphk
