// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/core/error_fields.hpp"
#include "kernels/core/family_fields.hpp"
#include "kernels/core/fields.hpp"

namespace sphk {

/// Numbers per particle of field F in D dimensions.
template <class F, int D>
inline constexpr int components = static_cast<int>(sizeof(typename F::template Value<double, D>) / sizeof(double));

/// The values of a set of fields for one particle, or for one pack of them: Values<T, D, List<Mass, Density>> has .m,
/// .rho.
template <class T, int D, class Fields>
struct Values;
template <class T, int D, class... F>
struct Values<T, D, List<F...>> : F::template Value<T, D>... {
  using Fields = List<F...>;
};

/// The components of field F inside `values`, as an array.
template <class F, class T, int D, class Fields>
KOKKOS_FORCEINLINE_FUNCTION T* component_array(Values<T, D, Fields>& values) {
  return reinterpret_cast<T*>(static_cast<typename F::template Value<T, D>*>(&values));
}
template <class F, class T, int D, class Fields>
KOKKOS_FORCEINLINE_FUNCTION const T* component_array(const Values<T, D, Fields>& values) {
  return reinterpret_cast<const T*>(static_cast<const typename F::template Value<T, D>*>(&values));
}

namespace detail {

template <int D, class G, class... F>
constexpr int offset_of(List<F...>) {
  int offset = 0;
  bool found = false;
  ((found = found || std::is_same_v<F, G>, offset += found ? 0 : components<F, D>), ...);
  return offset;
}

template <int D, class... F>
constexpr int total_components(List<F...>) {
  return (0 + ... + components<F, D>);
}

template <class F, class T, int D, class Fields>
KOKKOS_FORCEINLINE_FUNCTION void fill_field(Values<T, D, Fields>& values, T number) {
  T* c = component_array<F>(values);
  for (int k = 0; k < components<F, D>; ++k) c[k] = number;
}

template <class F, class T, class U, int D, class Fields>
KOKKOS_FORCEINLINE_FUNCTION void accumulate_field(Values<T, D, Fields>& to, const Values<U, D, Fields>& packs) {
  T* out = component_array<F>(to);
  const U* in = component_array<F>(packs);
  for (int k = 0; k < components<F, D>; ++k) {
    if constexpr (F::facts.maximum)
      out[k] = max(out[k], T(max_lanes(in[k])));
    else
      out[k] += T(sum_lanes(in[k]));
  }
}

}  // namespace detail

/// First component of field G among the components of all Fields.
template <int D, class G, class Fields>
inline constexpr int component_offset = detail::offset_of<D, G>(Fields{});

template <int D, class Fields>
inline constexpr int component_count = detail::total_components<D>(Fields{});

template <class T, int D, class... F>
KOKKOS_FORCEINLINE_FUNCTION void set_zero(Values<T, D, List<F...>>& values) {
  (detail::fill_field<F>(values, T(0)), ...);
}

/// Adds the sum over the lanes of `packs` (or takes the maximum, where the field is one) to `to`.
template <class T, class U, int D, class... F>
KOKKOS_FORCEINLINE_FUNCTION void accumulate(Values<T, D, List<F...>>& to, const Values<U, D, List<F...>>& packs) {
  (detail::accumulate_field<F>(to, packs), ...);
}

}  // namespace sphk
