#pragma once

#include "kernels/terms/density.hpp"
#include "src/engine/scheme.hpp"

namespace sphk {

using ClassicDensity = TermSet<DensitySum, VelocityDivergenceSum, VelocityCurlSum>;
using ClassicStep = Passes<KickDrift, SortedCells, SmoothingLength, StateEquation, Rates, KickTimeStep>;

}  // namespace sphk
