#include "src/schemes/labels.hpp"

#include <algorithm>
#include <regex>

namespace sphk {

std::optional<KeyValues> keys_of_label(const std::string& text) {
  static const std::regex label(
      "(SPH|TSPH|OSPH|SPHS)-(CS|CT|HCT|HOCT[3458]|LIQ|M[56]|WC[246])(-?)([0-9]+)(e?)(-?multi)?(-?g)?");
  std::smatch part;
  if (!std::regex_match(text, part, label)) return std::nullopt;
  const bool r10 = part[3].length() > 0, morris = part[5].length() > 0;
  std::string scheme = part[1];
  if (scheme == "SPH" && !r10) scheme = "gadget2";
  if (morris && scheme != "SPHS") return std::nullopt;
  std::string kernel = part[2] == "HCT" ? "HOCT4" : std::string(part[2]);
  for (std::string* name : {&scheme, &kernel})
    std::ranges::transform(*name, name->begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  KeyValues keys{
      {"sph.scheme", morris ? scheme + "-morris" : scheme}, {"sph.kernel", kernel}, {"sph.neighbours", part[4]}};
  if (scheme == "sphs") keys.emplace_back("sph.energy", "entropy");  // whatever the scene prefers
  if (part[6].matched) keys.emplace_back("scene.masses", "multi");
  if (part[7].matched) keys.emplace_back("scene.lattice", "glass");
  return keys;
}

}  // namespace sphk
