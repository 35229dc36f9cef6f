// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Macros.hpp>
#include <type_traits>

namespace sphk {

/// A compile-time list of types.
template <class... Ts>
struct List {
  static constexpr int size = sizeof...(Ts);
};

namespace detail {

template <class T, class L>
struct Contains;
template <class T, class... Ts>
struct Contains<T, List<Ts...>> : std::bool_constant<(std::is_same_v<T, Ts> || ...)> {};

template <class Out, class... Ls>
struct Unite {
  using type = Out;
};
template <class... Os, class T, class... Ts, class... Ls>
struct Unite<List<Os...>, List<T, Ts...>, Ls...>
    : Unite<std::conditional_t<Contains<T, List<Os...>>::value, List<Os...>, List<Os..., T>>, List<Ts...>, Ls...> {};
template <class Out, class... Ls>
struct Unite<Out, List<>, Ls...> : Unite<Out, Ls...> {};

}  // namespace detail

template <class T, class L>
inline constexpr bool contains = detail::Contains<T, L>::value;

/// All types of the lists, each once, in the order of first appearance.
template <class... Ls>
using Union = typename detail::Unite<List<>, Ls...>::type;

namespace detail {
template <template <class> class Keep, class... Ts>
struct Filtered {
  using type = Union<std::conditional_t<Keep<Ts>::value, List<Ts>, List<>>...>;
};
template <class L, template <class> class Keep>
struct FilterOf;
template <class... Ts, template <class> class Keep>
struct FilterOf<List<Ts...>, Keep> : Filtered<Keep, Ts...> {};
}  // namespace detail

/// The types of list L for which Keep<T>::value holds.
template <class L, template <class> class Keep>
using Filter = typename detail::FilterOf<L, Keep>::type;

/// Calls f.template operator()<T>() for every T of the list.
template <class... Ts, class F>
KOKKOS_FORCEINLINE_FUNCTION constexpr void for_each_type(List<Ts...>, F&& f) {
  (f.template operator()<Ts>(), ...);
}

/// Does List Long begin with the types of List Front, in their order?
template <class Long, class Front>
inline constexpr bool starts_with = false;
template <class Long>
inline constexpr bool starts_with<Long, List<>> = true;
template <class T, class... Long, class... Front>
inline constexpr bool starts_with<List<T, Long...>, List<T, Front...>> = starts_with<List<Long...>, List<Front...>>;

template <class Small, class Large>
inline constexpr bool is_subset = false;
template <class... Ts, class Large>
inline constexpr bool is_subset<List<Ts...>, Large> = (contains<Ts, Large> && ...);

}  // namespace sphk
