#pragma once

#include "kernels/terms/pressure_gradient_tsph.hpp"
#include "kernels/terms/pressure_work.hpp"
#include "kernels/terms/viscosity_gingold_monaghan.hpp"
#include "src/schemes/classic.hpp"

namespace sphk {

/// TSPH, R10 Table 2: phi = rho in the momentum equation.
template <int D, class K, class T>
struct Tsph : Scheme<D, K, T, EntropyForm, ClassicDensity,
                     TermSet<PressureGradientTsph, ViscosityGingoldMonaghan, SignalVelocityMonaghan>, ClassicStep> {};
template <int D, class K, class T>
struct TsphEnergy
    : Scheme<D, K, T, EnergyForm, ClassicDensity,
             TermSet<PressureGradientTsph, PressureWork, ViscosityGingoldMonaghan, SignalVelocityMonaghan>,
             ClassicStep> {};

}  // namespace sphk
