// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "src/engine/particle_set.hpp"
#include "src/io/hdf5_file.hpp"
#include "src/io/units.hpp"

namespace sphk {

/// What a file says of the run that it is for, wherever its layout has it; empty where it says nothing.
struct FileFacts {
  std::optional<bool> periodic;
  std::optional<double> dimension;
  std::optional<double> gamma;  ///< adiabatic index
  std::optional<Units> units;   ///< none: code units
  Array3 stretch{1, 1, 1};      ///< of BoxSize along each axis
};

/// The one place that knows where SWIFT (of any age), GADGET-2, GADGET-4, AREPO and GIZMO keep such things. Throws
/// InputError for what sphk cannot compute (comoving units, reflecting walls), for units that are no positive numbers,
/// and where two places say different things.
FileFacts facts_of(const hdf5::File& file);

}  // namespace sphk
