// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "kernels/passes/kick_drift.hpp"
#include "src/engine/field_places.hpp"

namespace sphk {

/// Rows of the columns that hold PredictedFields.
inline std::vector<int> predicted_rows(std::span<const FieldPlace> fields) {
  std::vector<int> rows;
  for (const FieldPlace& place : fields)
    for_each_type(PredictedFields{}, [&]<class F>() {
      for (int k = 0; place.facts == &F::facts && k < place.components; ++k) rows.push_back(place.row + k);
    });
  return rows;
}

}  // namespace sphk
