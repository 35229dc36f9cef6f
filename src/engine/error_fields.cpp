// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "src/engine/error_loops.hpp"

namespace sphk {

template <int D>
Columns<D, typename ErrorLayout<D>::Fields> error_columns(int n) {
  return {"errors", n};
}
template Columns<1, ErrorLayout<1>::Fields> error_columns<1>(int n);
template Columns<2, ErrorLayout<2>::Fields> error_columns<2>(int n);
template Columns<3, ErrorLayout<3>::Fields> error_columns<3>(int n);

namespace detail {

namespace {

Field changed(Field field, const FieldFacts& sum, const FieldFacts& facts, double (*change)(double)) {
  if (field.name != sum.name) return field;
  field.name = facts.name;
  field.description = facts.description;
  field.units = exponents(facts.unit, 3, 1);
  for (double& value : field.values) value = change(value);
  return field;
}

}  // namespace

std::vector<Field> written_errors(const HostRows& rows, std::span<const FieldPlace> places) {
  constexpr FieldFacts distance{.name = "NearestNeighbour",
                                .description = "Distance of the nearest neighbour; 0: none within h",
                                .unit = {.length = 1}};
  const FieldFacts& contrast = EntropyContrast::facts;
  std::vector<Field> fields;
  for (const FieldPlace& place : places) {
    Field field = changed(rows.field(place), InverseNearest::facts, distance,
                          [](double inverse) { return inverse > 0 ? 1 / inverse : 0; });
    fields.push_back(
        changed(std::move(field), contrast, contrast, [](double ratio) { return ratio > 1 ? std::log(ratio) : 0; }));
  }
  return fields;
}

}  // namespace detail

template std::vector<Field> error_fields(const Particles<ErrorLayout<1>>&, const Smoothing<AnyKernel, 1>&);
template std::vector<Field> error_fields(const Particles<ErrorLayout<2>>&, const Smoothing<AnyKernel, 2>&);
template std::vector<Field> error_fields(const Particles<ErrorLayout<3>>&, const Smoothing<AnyKernel, 3>&);

}  // namespace sphk
