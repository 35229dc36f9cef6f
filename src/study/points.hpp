// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "src/run/problem.hpp"

namespace sphk {

/// One key of a study and the values that it takes.
struct StudyAxis {
  std::string key;  ///< such as "sph.kernel"
  std::vector<std::string> values;
};

/// One run of a study: keys and values that differ from point to point, in the order of the axes.
struct StudyPoint {
  KeyTexts keys;

  /// The value of a key; empty where the study does not vary it.
  std::string value(const std::string& key) const;
  /// All values but the resolution's, as one label: "sphs hoct4 442", with the key where a value alone says little.
  std::string method() const;
  /// Unlike for unlike points, and a folder's name.
  std::string name() const;
};

/// The key whose values make a convergence study.
inline constexpr const char* resolution_key = "scene.n";

/// Every combination of the axes' values, the last axis fastest. An empty axis is left out.
std::vector<StudyPoint> product_of(const std::vector<StudyAxis>& axes);

}  // namespace sphk
