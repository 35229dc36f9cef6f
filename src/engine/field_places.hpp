// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "kernels/core/columns.hpp"

namespace sphk {

/// A field among the rows of a set of columns, for code that learns at run time which fields there are.
struct FieldPlace {
  const FieldFacts* facts;
  int row;         ///< of its first component
  int components;  ///< rows
};

namespace detail {
template <int D, class FieldList>
struct Places;
template <int D, class... F>
struct Places<D, List<F...>> {
  static constexpr std::array<FieldPlace, sizeof...(F)> list{
      FieldPlace{&F::facts, component_offset<D, F, List<F...>>, components<F, D>}...};
};
}  // namespace detail

/// The fields of a list of columns in D dimensions, in their order.
template <int D, class FieldList>
inline constexpr std::span<const FieldPlace> field_places{detail::Places<D, FieldList>::list};

}  // namespace sphk
