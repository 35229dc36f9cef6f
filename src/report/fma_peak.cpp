// SPDX-License-Identifier: BSD-3-Clause
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

/// Independent chains: more than latency (4 cycles) times throughput (2 a cycle of CPUs with 16 registers, up to 4 of
/// those with 32), and few enough to stay in registers.
constexpr int chains = host_registers == 32 ? 24 : 12;
constexpr int repeats = 16;

/// Each chain turns x into a x + b, `length` times. With a < 1 the numbers converge: neither overflow nor denormals
/// slow the loop down. The sum keeps the compiler from leaving the work out.
template <class T>
KOKKOS_FUNCTION double chains_of_fma(int seed, long length) {
  using Register = simd<T, width<T>>;
  Register x[chains];
  for (int k = 0; k < chains; ++k) x[k] = Register(T(seed + k));
  const Register a(T(0.75)), b(T(0.5));
  for (long i = 0; i < length; ++i) {
#pragma GCC unroll 24
    for (int k = 0; k < chains; ++k) x[k] = x[k] * a + b;  // one operation where the CPU has it, else two
  }
  double sum = 0;
  for (int k = 0; k < chains; ++k) sum += static_cast<double>(sum_lanes(x[k]));
  return sum;
}

template <class T>
double operations(long length) {
  return 2.0 * chains * width<T> * static_cast<double>(length);
}

/// All threads at once; each counts the best of its loops of about 1 ms, so that another program on its core now and
/// then does not lower the peak.
template <class T>
struct HostRate {
  void operator()(int thread, double& rate, double& result) const {
    constexpr long length = 1 << 19;
    double best = 1e300;
    for (int repeat = 0; repeat < repeats; ++repeat) {
      const Kokkos::Timer timer;
      result += chains_of_fma<T>(thread, length);
      best = std::min(best, timer.seconds());
    }
    rate += operations<T>(length) / best;
  }
};

template <class T>
struct DeviceLoop {
  long length;
  KOKKOS_FUNCTION void operator()(int thread, double& result) const { result += chains_of_fma<T>(thread, length); }
};

template <class T>
double flops_per_second() {
  const int threads = Space().concurrency();
  double rate = 0, result = 0;
  if constexpr (on_host) {
    Kokkos::parallel_reduce("fma_peak", Kokkos::RangePolicy<Space>(0, threads), HostRate<T>{}, rate, result);
  } else {
    constexpr long length = 1 << 14;
    for (int repeat = 0; repeat < repeats; ++repeat) {
      const Kokkos::Timer timer;
      Kokkos::parallel_reduce("fma_peak", Kokkos::RangePolicy<Space>(0, 4 * threads), DeviceLoop<T>{length}, result);
      rate = std::max(rate, 4 * threads * operations<T>(length) / timer.seconds());
    }
  }
  return rate;
}

}  // namespace

FmaPeak measure_fma_peak() {
  return {flops_per_second<float>(), flops_per_second<double>()};
}

}  // namespace sphk
