// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/terms/term_set.hpp"

namespace sphk {

/// The acceleration by term Term alone.
template <class Term>
struct ApartAcceleration {
  static constexpr FieldFacts facts{
      .name = "Acceleration", .description = "dv/dt by the ", .unit = Acceleration::facts.unit, .rank = Rank::vector};
  template <class T, int D>
  struct Value {
    Vec<T, D> a_apart;
  };
};

/// du/dt by term Term alone.
template <class Term>
struct ApartHeating {
  static constexpr FieldFacts facts{.name = "Heating", .description = "du/dt by the ", .unit = Heating::facts.unit};
  template <class T, int D>
  struct Value {
    T du_apart;
  };
};

/// Is F one of these?
template <class F>
inline constexpr bool is_apart = false;
template <class Term>
inline constexpr bool is_apart<ApartAcceleration<Term>> = true;
template <class Term>
inline constexpr bool is_apart<ApartHeating<Term>> = true;

namespace detail {
template <class Term, class F>
struct ApartField {
  using type = F;
};
template <class Term>
struct ApartField<Term, Acceleration> {
  using type = ApartAcceleration<Term>;
};
template <class Term>
struct ApartField<Term, Heating> {
  using type = ApartHeating<Term>;
};
template <class Term, class L>
struct ApartFields;
template <class Term, class... F>
struct ApartFields<Term, List<F...>> {
  using type = List<typename ApartField<Term, F>::type...>;
};
}  // namespace detail

/// Term with sums of its own, so that several terms of one loop can be told apart.
template <class Term>
struct Apart : Term {
  using Term::Term;
  using Adds = typename detail::ApartFields<Term, typename Term::Adds>::type;

  template <class P, int D, class Fields>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(Values<P, D, Fields>& sum, const auto& i, const auto& j,
                                              const auto& ij) const {
    Values<P, D, typename Term::Adds> own;
    set_zero(own);
    static_cast<const Term&> (*this)(own, i, j, ij);
    if constexpr (contains<Acceleration, typename Term::Adds>) {
      auto& a = static_cast<typename ApartAcceleration<Term>::template Value<P, D>&>(sum).a_apart;
      a += own.a;
    }
    if constexpr (contains<Heating, typename Term::Adds>) {
      auto& du = static_cast<typename ApartHeating<Term>::template Value<P, D>&>(sum).du_apart;
      du = du + own.du;
    }
  }
};

}  // namespace sphk
