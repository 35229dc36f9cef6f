// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sphk {

/// Keys and their values, as in a scene file.
using KeyValues = std::vector<std::pair<std::string, std::string>>;

/// The keys that a paper's label stands for: S12's (SPHS-HCT442, SPH-CS42, with the suffixes e, -multi, -g) and R10's
/// (SPH-CS-128, TSPH-HOCT4-442), by what the schemes say of their labels. S12 integrate entropies, R10 energies (its
/// sec 3.2). Nothing where `text` is no such label.
std::optional<KeyValues> keys_of_label(const std::string& text);

}  // namespace sphk
