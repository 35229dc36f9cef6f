#pragma once

#include <filesystem>
#include <string>

namespace sphk {

/// Text as HTML shows it: &, <, > and quotation marks escaped.
std::string html_text(const std::string& text);
/// An <img> with the whole PNG in it. Throws InputError where the file cannot be read.
std::string html_image(const std::filesystem::path& png, const std::string& description);
/// A page that needs nothing beside itself; reads well on a screen, small or dark, and printed.
std::string html_page(const std::string& title, const std::string& body);

}  // namespace sphk
