#pragma once

#include "kernels/terms/velocity_gradient.hpp"
#include "src/engine/scheme.hpp"

namespace sphk {

using ClassicDensity = TermSet<VelocityDivergenceSum, VelocityCurlSum>;
using ClassicStep =
    Passes<KickDrift, SortedCells, ActiveParticles, SmoothingLength, StateEquation, Rates, KickTimeStep, NextSteps>;

}  // namespace sphk
