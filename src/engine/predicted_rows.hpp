#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "src/engine/field_places.hpp"

namespace sphk {

/// Rows of the columns that the prediction of sleeping particles changes (Motion::predict in kick_drift.hpp).
inline std::vector<int> predicted_rows(std::span<const FieldPlace> fields) {
  static constexpr const FieldFacts* predicted[] = {&Velocity::facts,
                                                    &Thermal::facts,
                                                    &Mass::facts,
                                                    &Support::facts,
                                                    &InverseSupport::facts,
                                                    &Density::facts,
                                                    &GeneralDensity::facts,
                                                    &InverseDensity::facts,
                                                    &Pressure::facts,
                                                    &SmoothedPressure::facts,
                                                    &PressureOverDensity2::facts,
                                                    &SoundSpeed::facts};
  std::vector<int> rows;
  for (const FieldPlace& place : fields)
    if (std::ranges::find(predicted, place.facts) != std::end(predicted))
      for (int k = 0; k < place.components; ++k) rows.push_back(place.row + k);
  return rows;
}

}  // namespace sphk
