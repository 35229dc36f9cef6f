#pragma once

namespace sphk {

/// Code units in cgs.
struct Units {
  double length = 1, mass = 1, time = 1;
};

}  // namespace sphk
