// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/diagnostics.hpp"

namespace sphk {

std::vector<Field> shown_in_rates(const HostRows& rows, std::span<const FieldPlace> fields) {
  std::vector<Field> shown;
  for (const FieldPlace& place : fields)
    if (place.facts->shown != Shown::nowhere)
      shown.push_back(rows.field(place, {singular_name(*place.facts), place.facts->description}));
  return shown;
}

std::vector<Field> shares(const HostRows& rows, const std::vector<TermShare>& shares) {
  std::vector<Field> fields;
  for (const TermShare& share : shares)
    fields.push_back(rows.field(share.place, {std::string(share.place.facts->name) + share.label,
                                              std::string(share.place.facts->description) + share.term}));
  return fields;
}

}  // namespace sphk
