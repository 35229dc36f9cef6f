#include "src/report/html.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <map>

#include "src/engine/errors.hpp"

namespace sphk {

namespace {

constexpr const char* style = R"(
:root { color-scheme: light dark; --ink: #1b1f24; --quiet: #57606a; --line: #d0d7de; --paper: #ffffff; --stripe: #f6f8fa; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6edf3; --quiet: #9da7b3; --line: #3d444d; --paper: #0d1117; --stripe: #161b22; }
}
body { margin: 2rem auto; max-width: 72rem; padding: 0 1.2rem; color: var(--ink); background: var(--paper);
  font: 16px/1.5 system-ui, "DejaVu Sans", sans-serif; }
h1 { font-size: 1.7rem; line-height: 1.2; margin-bottom: .3rem; }
h2 { font-size: 1.2rem; margin: 2rem 0 .5rem; break-after: avoid; }
p.meta, figcaption { color: var(--quiet); }
figure { margin: 1.2rem 0; break-inside: avoid; }
img { max-width: 100%; height: auto; background: #ffffff; border-radius: 4px; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .88rem; font-variant-numeric: tabular-nums; }
th, td { padding: .28rem .7rem; text-align: right; border-bottom: 1px solid var(--line); white-space: nowrap; }
.words { text-align: left; }
thead th { border-bottom: 2px solid var(--line); }
tbody tr:nth-child(even) { background: var(--stripe); }
tr { break-inside: avoid; }
pre { background: var(--stripe); padding: .8rem 1rem; overflow-x: auto; border-radius: 4px; white-space: pre-wrap; }
.tiles { display: grid; grid-template-columns: repeat(auto-fill, minmax(19rem, 1fr)); gap: 1.2rem; }
.tiles figure { margin: 0; border: 1px solid var(--line); border-radius: 6px; padding: .7rem; }
.tiles figcaption b { color: var(--ink); }
@media print {
  :root { --ink: #000; --quiet: #444; --line: #bbb; --paper: #fff; --stripe: #f4f4f4; }
  @page { size: A4; margin: 15mm; }
  body { margin: 0; max-width: none; font-size: 10pt; padding: 0; }
  table { font-size: 7.2pt; }
  th, td { padding: .15rem .35rem; }
  .wide { overflow: visible; }
  .tiles { grid-template-columns: repeat(3, 1fr); gap: 4mm; }
}
)";

std::string base64(const std::string& bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const auto byte = [&](std::size_t j) { return j < bytes.size() ? static_cast<unsigned char>(bytes[j]) : 0u; };
    const unsigned word = byte(k) << 16 | byte(k + 1) << 8 | byte(k + 2);
    for (int j = 0; j < 4; ++j)
      text += k + static_cast<std::size_t>(j) <= bytes.size() ? digits[word >> (18 - 6 * j) & 63] : '=';
  }
  return text;
}

}  // namespace

std::string html_text(const std::string& text) {
  static const std::map<char, std::string> escapes{{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};
  std::string html;
  for (const char c : text) html += escapes.contains(c) ? escapes.at(c) : std::string(1, c);
  return html;
}

std::string html_image(const std::filesystem::path& png, const std::string& description) {
  std::ifstream file(png, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (bytes.empty()) throw InputError(fmt::format("cannot read the figure {}", png.string()));
  return fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">", html_text(description), base64(bytes));
}

std::string html_page(const std::string& title, const std::string& body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}</body>\n</html>\n",
      html_text(title), style, body);
}

}  // namespace sphk
