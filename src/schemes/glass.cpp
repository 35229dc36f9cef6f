#include "kernels/passes/damping.hpp"
#include "kernels/passes/smoothing_length.hpp"
#include "kernels/terms/pressure_gradient_conservative.hpp"
#include "kernels/terms/signal_velocity.hpp"
#include "src/schemes/classic.hpp"
#include "src/schemes/instantiate.hpp"

namespace sphk {

namespace {

/// Isentropic gas with friction: it settles into a glass, an even arrangement without a preferred direction.
template <int D, class K, class T>
struct Glass
    : Scheme<D, K, T, EntropyForm, TermSet<>, TermSet<PressureGradientConservative, SignalVelocity>,
             Passes<KickDrift, SortedCells, SmoothingLength, StateEquation, GradH, Rates, KickTimeStep, Damping>> {};

}  // namespace

Instantiations glass() {
  Instantiations rows;
  detail::append<Glass, 1, float>(rows, "glass", "entropy", List<CubicSpline>{});
  detail::append<Glass, 2, float>(rows, "glass", "entropy", List<CubicSpline>{});
  detail::append<Glass, 3, float>(rows, "glass", "entropy", List<CubicSpline>{});
  return rows;
}

}  // namespace sphk
