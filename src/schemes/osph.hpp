#pragma once

#include "kernels/passes/general_density.hpp"
#include "kernels/terms/pressure_gradient_coherent.hpp"
#include "kernels/terms/pressure_gradient_general.hpp"
#include "kernels/terms/viscosity_gingold_monaghan.hpp"
#include "src/schemes/classic.hpp"

namespace sphk {

/// Steps of the schemes with a generalised continuity equation.
template <class Continuity, class Functions>
using GeneralStep = Passes<KickDrift, SortedCells, ActiveParticles, SmoothingLength, Continuity, StateEquation,
                           Functions, Rates, KickTimeStep, NextSteps>;

/// The generalised family of R10 eq 16-19: any eta, phi and zeta, types such as those of free_functions.hpp. With A
/// integrated zeta plays no part.
template <class Eta, class Phi>
struct EntropyFamily {
  template <int D, class K, class T>
  struct Type : Scheme<D, K, T, EntropyForm, ClassicDensity,
                       TermSet<PressureGradientGeneral<Phi>, ViscosityGingoldMonaghan, SignalVelocityMonaghan>,
                       GeneralStep<GeneralContinuity<Eta>, FreeFunctions<Phi, One>>> {};
};
template <class Eta, class Phi, class Zeta>
struct EnergyFamily {
  template <int D, class K, class T>
  struct Type : Scheme<D, K, T, EnergyForm, ClassicDensity,
                       TermSet<PressureGradientGeneral<Phi>, PressureWorkGeneral, ViscosityGingoldMonaghan,
                               SignalVelocityMonaghan>,
                       GeneralStep<GeneralContinuity<Eta>, FreeFunctions<Phi, Zeta>>> {};
};

/// OSPH, R10 Table 2.
template <int D, class K, class T>
struct OsphEntropy : EntropyFamily<InverseEntropyRoot, DensityItself>::Type<D, K, T> {};
template <int D, class K, class T>
struct OsphEnergy : EnergyFamily<InverseEnergy, DensityItself, InverseEnergy>::Type<D, K, T> {};

/// Pseudo-coherent OSPH with grad-h (R10 footnote 4): eta = phi = zeta.
template <int D, class K, class T>
struct OsphCoherentEntropy
    : Scheme<
          D, K, T, EntropyForm, ClassicDensity,
          TermSet<PressureGradientCoherent<InverseEntropyRoot>, ViscosityGingoldMonaghan, SignalVelocityMonaghan>,
          GeneralStep<CoherentContinuity<InverseEntropyRoot>, FreeFunctions<InverseEntropyRoot, InverseEntropyRoot>>> {
};
template <int D, class K, class T>
struct OsphCoherentEnergy
    : Scheme<D, K, T, EnergyForm, ClassicDensity,
             TermSet<PressureGradientCoherent<InverseEnergy>, PressureWorkCoherent, ViscosityGingoldMonaghan,
                     SignalVelocityMonaghan>,
             GeneralStep<CoherentContinuity<InverseEnergy>, FreeFunctions<InverseEnergy, InverseEnergy>>> {};

}  // namespace sphk
