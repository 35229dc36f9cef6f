#include "kernels/passes/rt_pressure.hpp"
#include "src/schemes/every_dimension.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

namespace {

/// SPHS with the RT pressure (S12 App. A), the negative control: smooth pressures cost the kernel its sampling where
/// entropies differ much.
template <int D, class K, class T>
struct SphsRt : Scheme<D, K, T, EntropyForm, TermSet<>,
                       TermSet<PressureGradientTsph, ViscositySwitched, EntropyDissipation, SignalVelocity>,
                       SphsPasses<RtPressure>::With<>> {};

}  // namespace

Instantiations sphs_rt() {
  return in_every_dimension<SphsRt>("sphs-rt", "entropy", List<Hoct<4>>{});
}

}  // namespace sphk
