#pragma once

#include <vector>

#include "src/engine/particle_set.hpp"

namespace sphk {

/// Relaxes particles of equal mass in the periodic box [0, size) by the scheme "glass", motion under the pressure of an
/// even gas with damping, until the scatter of the density stops falling.
std::vector<Array3> relax_with_engine(int dimension, const Array3& size, std::vector<Array3> start);

}  // namespace sphk
