#pragma once

#include "kernels/passes/general_density.hpp"
#include "kernels/terms/artificial_conductivity.hpp"
#include "kernels/terms/pressure_gradient_conservative.hpp"
#include "kernels/terms/signal_velocity.hpp"
#include "kernels/terms/viscosity_valcke.hpp"
#include "src/schemes/classic.hpp"

namespace sphk {

/// Passes of V10's scheme; those of a conductivity before the rates.
template <class... BeforeRates>
using V10Step = Passes<KickDrift, SortedCells, ActiveParticles, SmoothingLength, StateEquation, GradH, BeforeRates...,
                       Rates, KickTimeStep, NextSteps>;

/// GADGET-2's scheme with V10's viscosity and artificial conductivity (V10 sec 2).
template <int D, class K, class T>
struct V10 : Scheme<D, K, T, EntropyForm, ClassicDensity,
                    TermSet<PressureGradientConservative, ViscosityValcke, ArtificialConductivity, SignalVelocity>,
                    V10Step<>> {};
/// With the signal velocity of smoothed pressures (V10 eq 6).
template <int D, class K, class T>
struct V10Smoothed
    : Scheme<D, K, T, EntropyForm, ClassicDensity,
             TermSet<PressureGradientConservative, ViscosityValcke, ArtificialConductivitySmoothed, SignalVelocity>,
             V10Step<SmoothedPressures>> {};
/// Without conductivity (V10's series NOAC).
template <int D, class K, class T>
struct V10Plain : Scheme<D, K, T, EntropyForm, ClassicDensity,
                         TermSet<PressureGradientConservative, ViscosityValcke, SignalVelocity>, V10Step<>> {};

/// V10 with u integrated and no work done on it: what relaxes an initial condition (V10 sec 4.5.1).
template <int D, class K, class T>
struct V10Relaxation
    : Scheme<D, K, T, EnergyForm, ClassicDensity,
             TermSet<PressureGradientConservative, ViscosityValcke, ArtificialConductivity, SignalVelocity>,
             V10Step<>> {};

}  // namespace sphk
