#pragma once

#include "kernels/terms/density.hpp"
#include "kernels/terms/pressure_gradient.hpp"
#include "kernels/terms/signal_velocity.hpp"
#include "kernels/terms/viscosity.hpp"
#include "src/engine/scheme.hpp"

namespace sphk {

using ClassicDensity = TermSet<NumberDensitySum, DensitySum, VelocityDivergenceSum, VelocityCurlSum>;
using ClassicStep = Passes<KickDrift, SortedCells, SmoothingLength, StateEquation, Rates, KickTimeStep>;

/// SPH as in R10: no grad-h, Gingold & Monaghan's viscosity with the Balsara switch.
template <int D, class K, class T>
struct SphEntropy : Scheme<D, K, T, EntropyForm, ClassicDensity,
                           TermSet<PressureGradientSph, ViscosityGingoldMonaghan, SignalVelocityMonaghan>, ClassicStep> {};
template <int D, class K, class T>
struct SphEnergy : Scheme<D, K, T, EnergyForm, ClassicDensity,
                          TermSet<PressureGradientSph, PressureWork, ViscosityGingoldMonaghan, SignalVelocityMonaghan>,
                          ClassicStep> {};

/// TSPH, R10 Table 2: phi = rho in the momentum equation.
template <int D, class K, class T>
struct Tsph : Scheme<D, K, T, EntropyForm, ClassicDensity,
                     TermSet<PressureGradientTsph, ViscosityGingoldMonaghan, SignalVelocityMonaghan>, ClassicStep> {};

/// Classic SPH as in GADGET-2 (Springel 2005): entropy, grad-h, signal-velocity viscosity with the Balsara switch.
template <int D, class K, class T>
struct Gadget2 : Scheme<D, K, T, EntropyForm, ClassicDensity,
                        TermSet<PressureGradientConservative, ViscositySignalVelocity, SignalVelocity>, ClassicStep> {};

}  // namespace sphk
