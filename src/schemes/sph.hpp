#pragma once

#include "kernels/terms/pressure_gradient_sph.hpp"
#include "kernels/terms/pressure_work.hpp"
#include "kernels/terms/viscosity_gingold_monaghan.hpp"
#include "src/schemes/classic.hpp"

namespace sphk {

/// SPH as in R10: no grad-h, Gingold & Monaghan's viscosity with the Balsara switch.
template <int D, class K, class T>
struct SphEntropy
    : Scheme<D, K, T, EntropyForm, ClassicDensity,
             TermSet<PressureGradientSph, ViscosityGingoldMonaghan, SignalVelocityMonaghan>, ClassicStep> {};
template <int D, class K, class T>
struct SphEnergy : Scheme<D, K, T, EnergyForm, ClassicDensity,
                          TermSet<PressureGradientSph, PressureWork, ViscosityGingoldMonaghan, SignalVelocityMonaghan>,
                          ClassicStep> {};

}  // namespace sphk
