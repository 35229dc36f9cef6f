// SPDX-License-Identifier: BSD-3-Clause
#include "src/schemes/labels.hpp"

#include <algorithm>
#include <regex>

#include "kernels/passes/state_equation.hpp"
#include "src/schemes/registry.hpp"

namespace sphk {

namespace {

/// A scheme and what its paper integrates.
struct Labelled {
  const SchemeFacts* scheme;
  const char* energy;
};

/// The scheme that a paper means; the other paper's, where this one does not have it.
std::optional<Labelled> scheme_of(const std::string& label, const std::string& suffix, bool r10) {
  const char *own = EntropyForm::name, *others = EnergyForm::name;
  if (r10) std::swap(own, others);
  std::optional<Labelled> other;
  const auto is = [&](const char* name) { return name && label == name; };
  for (const SchemeEntry& entry : known_schemes()) {
    const SchemeFacts& scheme = *entry.facts;
    if (suffix != scheme.label_suffix) continue;
    if (is(r10 ? scheme.r10_label : scheme.s12_label)) return Labelled{&scheme, own};
    if (is(r10 ? scheme.s12_label : scheme.r10_label)) other = Labelled{&scheme, others};
  }
  return other;
}

/// The kernel that a paper writes so, or nothing.
std::optional<std::string> kernel_of(std::string word) {
  if (word == "HCT") return "hoct4";  // S12
  std::ranges::transform(word, word.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::vector<std::string> known = kernel_names();
  return std::ranges::find(known, word) == known.end() ? std::nullopt : std::optional(word);
}

}  // namespace

std::optional<KeyValues> keys_of_label(const std::string& text) {
  // HCT442 is HCT with 442 neighbours, WC2100 is WC2 with 100: kernels without a number of their own come first.
  static const std::regex forms[] = {std::regex("([A-Z0-9]+)-([A-Z]+)(-?)([0-9]+)(e?)(-?multi)?(-?g)?"),
                                     std::regex("([A-Z0-9]+)-([A-Z]+[0-9])(-?)([0-9]+)(e?)(-?multi)?(-?g)?")};
  for (const std::regex& form : forms) {
    std::smatch part;
    if (!std::regex_match(text, part, form)) continue;
    const auto kernel = kernel_of(part[2]);
    const auto labelled = scheme_of(part[1], part[5], part[3].length() > 0);
    if (!kernel || !labelled) continue;
    KeyValues keys{{"sph.scheme", labelled->scheme->name},
                   {"sph.kernel", *kernel},
                   {"sph.neighbours", part[4]},
                   {"sph.energy", labelled->energy}};  // whatever the scene prefers
    if (part[6].matched) keys.emplace_back("scene.masses", "multi");
    if (part[7].matched) keys.emplace_back("scene.lattice", "glass");
    return keys;
  }
  return std::nullopt;
}

}  // namespace sphk
