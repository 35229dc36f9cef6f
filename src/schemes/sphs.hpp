#pragma once

#include "kernels/terms/entropy_dissipation.hpp"
#include "kernels/terms/mass_dissipation.hpp"
#include "kernels/terms/pressure_gradient_conservative.hpp"
#include "kernels/terms/pressure_gradient_tsph.hpp"
#include "kernels/terms/pressure_work_tsph.hpp"
#include "kernels/terms/signal_velocity.hpp"
#include "kernels/terms/viscosity_switched.hpp"
#include "src/engine/scheme.hpp"

namespace sphk {

/// Passes of SPHS before and after what the momentum form and mass dissipation add.
template <class... BeforeRates>
struct SphsPasses {
  template <class... AfterRates>
  using With = Passes<KickDrift, SortedCells, ActiveParticles, SmoothingLength, StateEquation, BeforeRates...,
                      Gradients, ConvergenceSwitch, Rates, AfterRates..., KickTimeStep, NextSteps>;
};

/// SPHS (Read & Hayfield 2012): the switch of the fitted velocity gradients drives every dissipation.
template <int D, class K, class T>
struct Sphs : Scheme<D, K, T, EntropyForm, TermSet<>,
                     TermSet<PressureGradientTsph, ViscositySwitched, EntropyDissipation, SignalVelocity>,
                     SphsPasses<>::With<>> {};

/// The same for particles of unequal masses.
template <int D, class K, class T>
struct SphsMulti
    : Scheme<D, K, T, EntropyForm, TermSet<>,
             TermSet<PressureGradientTsph, ViscositySwitched, EntropyDissipation, MassDissipation, SignalVelocity>,
             SphsPasses<>::With<MassExchange>> {};

/// Both with u in place of A: eq 7 conserves energy with the work that it does, not with a constant A.
template <int D, class K, class T>
struct SphsEnergy
    : Scheme<D, K, T, EnergyForm, TermSet<>,
             TermSet<PressureGradientTsph, PressureWorkTsph, ViscositySwitched, EntropyDissipation, SignalVelocity>,
             SphsPasses<>::With<>> {};
template <int D, class K, class T>
struct SphsEnergyMulti : Scheme<D, K, T, EnergyForm, TermSet<>,
                                TermSet<PressureGradientTsph, PressureWorkTsph, ViscositySwitched, EntropyDissipation,
                                        MassDissipation, SignalVelocity>,
                                SphsPasses<>::With<MassExchange>> {};

/// With the conservative momentum equation (S12 App. B).
template <int D, class K, class T>
struct SphsConservative
    : Scheme<
          D, K, T, EntropyForm, TermSet<>,
          TermSet<PressureGradientConservative, ViscositySwitched, EntropyDissipation, MassDissipation, SignalVelocity>,
          SphsPasses<GradH>::With<MassExchange>> {};

}  // namespace sphk
