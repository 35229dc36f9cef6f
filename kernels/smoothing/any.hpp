// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>

#include "kernels/smoothing/list.hpp"
#include "kernels/smoothing/tabulated.hpp"

namespace sphk {

/// Those of the list, and what stands for every other.
using AnyOfKernels = Union<SmoothingKernels, List<OwnKernel>>;

namespace detail {
template <class L>
struct EachOf;
template <class... Kernel>
struct EachOf<List<Kernel...>> : Kernel... {};
}  // namespace detail

/// Any kernel of the list in closed form, or a module's, chosen at run time: for loops that run so seldom that one for
/// all kernels, compiled once, is worth a call a pair.
class AnyKernel : detail::EachOf<AnyOfKernels> {
 public:
  template <class Kernel>
  explicit AnyKernel(const Kernel& kernel) {
    static_cast<Kernel&>(*this) = kernel;
    int k = 0;
    for_each_type(AnyOfKernels{}, [&]<class Other>() {
      if (std::is_same_v<Other, Kernel>) chosen_ = k;
      ++k;
    });
  }

  template <class T>
  [[gnu::noinline]] KOKKOS_FUNCTION Shape<T> operator()(T q) const {
    return with<Shape<T>>([&](const auto& kernel) { return kernel(q); });
  }
  template <class T>
  [[gnu::noinline]] KOKKOS_FUNCTION Shape<T> with_own_derivative(T q) const {
    return with<Shape<T>>([&](const auto& kernel) { return sphk::with_own_derivative(kernel, q); });
  }
  template <class T>
  KOKKOS_INLINE_FUNCTION T w(T q) const {
    return (*this)(q).w;
  }
  KOKKOS_INLINE_FUNCTION double norm(int dimension) const {
    return with<double>([&](const auto& kernel) { return kernel.norm(dimension); });
  }
  KOKKOS_INLINE_FUNCTION double norm_of_forces(int dimension) const {
    return with<double>([&](const auto& kernel) { return sphk::norm_of_forces(kernel, dimension); });
  }

 private:
  template <class Result>
  KOKKOS_FORCEINLINE_FUNCTION Result with(const auto& f) const {
    Result result{};
    int k = 0;
    for_each_type(AnyOfKernels{}, [&]<class Kernel>() {
      if (k++ == chosen_) result = f(static_cast<const Kernel&>(*this));
    });
    return result;
  }

  int chosen_ = 0;
};

/// The kernel of loops that run seldom, for runs with kernel K: AnyKernel, or a kernel of one's own itself.
template <class K>
auto seldom_used(const K& kernel) {
  if constexpr (contains<K, SmoothingKernels>)
    return AnyKernel(kernel);
  else
    return kernel;
}
inline AnyKernel seldom_used(const Tabulated& table) {
  return with_kernel(table.name(), [](const auto& kernel) { return AnyKernel(kernel); });
}

}  // namespace sphk
