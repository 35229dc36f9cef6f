#include "src/report/fma_peak.hpp"

#include <Kokkos_Core.hpp>
#include <algorithm>
#include <type_traits>

#include "kernels/core/simd.hpp"

namespace sphk {

namespace {

using Space = Kokkos::DefaultExecutionSpace;
constexpr bool on_host = std::is_same_v<Space::memory_space, Kokkos::HostSpace>;

template <class T>
constexpr int width = on_host ? native_lanes<T> : 1;

/// The widest number a thread holds: a SIMD pack on a CPU, a scalar on a GPU.
template <class T>
using Register = simd<T, width<T>>;

/// 12 independent chains: more than latency (4 cycles) times throughput (2 a cycle) of any CPU of today, and few enough
/// to stay in 16 registers.
constexpr int chains = 12;

/// Each thread turns x into a x + b. With a < 1 the numbers converge: neither overflow nor denormals slow the loop down.
template <class T>
struct FmaLoop {
  long length;

  KOKKOS_FUNCTION void operator()(int thread, double& sum) const {
    Register<T> x[chains];
    for (int k = 0; k < chains; ++k) x[k] = Register<T>(T(thread + k));
    const Register<T> a(T(0.75)), b(T(0.5));
    for (long i = 0; i < length; ++i)
      for (int k = 0; k < chains; ++k) x[k] = Kokkos::fma(x[k], a, b);
    for (int k = 0; k < chains; ++k) sum += first(x[k]);
  }

  KOKKOS_FUNCTION static double first(const Register<T>& x) {
    if constexpr (width<T> == 1) return static_cast<double>(x);
    else return static_cast<double>(x[0]);
  }
};

template <class T>
double seconds(int threads, long length) {
  Space space;
  double sum = 0;
  space.fence();
  Kokkos::Timer timer;
  Kokkos::parallel_reduce("fma_peak", Kokkos::RangePolicy<Space>(space, 0, threads), FmaLoop<T>{length}, sum);
  space.fence();
  return timer.seconds();
}

/// The best of 16 loops of about 1 ms: a peak is what the machine can do undisturbed.
template <class T>
double flops_per_second() {
  constexpr long length = on_host ? 1 << 19 : 1 << 14;
  const int threads = Space().concurrency() * (on_host ? 1 : 4);
  double best = seconds<T>(threads, length);
  for (int repeat = 0; repeat < 15; ++repeat) best = std::min(best, seconds<T>(threads, length));
  return 2.0 * chains * width<T> * static_cast<double>(length) * threads / best;
}

}  // namespace

double FmaPeak::of(std::string_view precision) const { return precision == "double" ? twofold : single; }

FmaPeak measure_fma_peak() { return {flops_per_second<float>(), flops_per_second<double>()}; }

}  // namespace sphk
