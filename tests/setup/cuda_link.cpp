#include <Kokkos_Core.hpp>

#include <cstdio>

// Compiles and links with nvcc; on a GPU it also runs: 0 + 1 + ... + 99 = 4950.
struct Sum {
  Kokkos::View<double*> values;
  KOKKOS_FUNCTION void operator()(int i, double& sum) const { sum += values(i) = i; }
};

int main() {
  const Kokkos::ScopeGuard kokkos(Kokkos::InitializationSettings().set_disable_warnings(true));
  double sum = 0;
  Kokkos::parallel_reduce("sum", 100, Sum{Kokkos::View<double*>("values", 100)}, sum);
  std::printf("%g\n", sum);
  return sum == 4950 ? 0 : 1;
}
