// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/core/unit.hpp"

namespace sphk {

/// What the components of a field are: `axial` a curl, of which 2D has its z alone; `matrix` a symmetric one, the
/// diagonal before xy, xz, yz.
enum class Rank { scalar, vector, axial, matrix };

/// What pair loops hold a field against, so that floats resolve differences: nothing, the place or the motion of their
/// cell.
enum class Relative { to_nothing, place, motion };

/// Where users see a field.
enum class Shown { nowhere, in_rates, in_snapshots };

/// All that is true of a field beside its symbol, which is the member of its Value.
struct FieldFacts {
  const char* name;  ///< of the dataset
  const char* description;
  Unit unit{};
  Rank rank = Rank::scalar;
  Relative relative = Relative::to_nothing;
  Shown shown = Shown::nowhere;    ///< in_snapshots: in `sphk rates` as well
  bool maximum = false;            ///< a sum over pairs takes the largest share of a pair
  const char* singular = nullptr;  ///< GADGET's name of the dataset, which `sphk rates` writes
};

}  // namespace sphk
