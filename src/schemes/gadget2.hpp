#pragma once

#include "kernels/terms/pressure_gradient_conservative.hpp"
#include "kernels/terms/signal_velocity.hpp"
#include "kernels/terms/viscosity_signal_velocity.hpp"
#include "src/schemes/classic.hpp"

namespace sphk {

/// Classic SPH as in GADGET-2 (Springel 2005): entropy, grad-h, signal-velocity viscosity with the Balsara switch.
template <int D, class K, class T>
struct Gadget2 : Scheme<D, K, T, EntropyForm, ClassicDensity,
                        TermSet<PressureGradientConservative, ViscositySignalVelocity, SignalVelocity>,
                        Passes<KickDrift, SortedCells, ActiveParticles, SmoothingLength, StateEquation, GradH, Rates,
                               KickTimeStep, NextSteps>> {};

}  // namespace sphk
