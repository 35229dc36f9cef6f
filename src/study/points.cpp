// SPDX-License-Identifier: BSD-3-Clause
#include "src/study/points.hpp"

#include <algorithm>
#include <cctype>

namespace sphk {

std::string StudyPoint::value(const std::string& key) const {
  const auto entry = std::ranges::find(keys, key, &KeyTexts::value_type::first);
  return entry == keys.end() ? "" : entry->second;
}

std::string StudyPoint::method() const {
  std::string label;
  for (const auto& [key, text] : keys) {
    if (key == resolution_key) continue;
    const bool number = key == "sph.neighbours" && !label.empty();  // as in "hoct4 442"
    const bool speaks = number || key == "sph.scheme" || key == "sph.kernel" || key == "sph.precision";
    label += (label.empty() ? "" : " ") + (speaks ? text : key + "=" + text);
  }
  return label.empty() ? "the scene's own" : label;
}

std::string StudyPoint::name() const {
  std::string text;
  for (const auto& [key, value] : keys) {
    const bool plain = key.starts_with("sph.") || key.starts_with("scene.");  // the names in these two are unlike
    text += (text.empty() ? "" : "_") + (plain ? key.substr(key.find('.') + 1) : key) + "-" + value;
  }
  for (char& c : text)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '.' && c != '-' && c != '_') c = '_';
  return text.empty() ? "point" : text;
}

std::vector<StudyPoint> product_of(const std::vector<StudyAxis>& axes) {
  std::vector<StudyPoint> points{{}};
  for (const StudyAxis& axis : axes) {
    if (axis.values.empty()) continue;
    std::vector<StudyPoint> longer;
    for (const StudyPoint& point : points)
      for (const std::string& value : axis.values) {
        longer.push_back(point);
        longer.back().keys.emplace_back(axis.key, value);
      }
    points = std::move(longer);
  }
  return points;
}

}  // namespace sphk
