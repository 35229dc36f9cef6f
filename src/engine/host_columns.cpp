// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/host_columns.hpp"

#include <algorithm>
#include <numeric>

namespace sphk {

namespace {

/// Where component k of a field in D dimensions stands among those of its output.
std::size_t output_component(Rank rank, int dimension, int k) {
  constexpr std::size_t matrix_places[3][6] = {{0}, {0, 1, 3}, {0, 1, 2, 3, 4, 5}};
  if (rank == Rank::axial && dimension < 3) return 2;
  if (rank == Rank::matrix) return matrix_places[dimension - 1][k];
  return static_cast<std::size_t>(k);
}

int output_components(Rank rank) {
  return rank == Rank::scalar ? 1 : rank == Rank::matrix ? 6 : 3;
}

}  // namespace

HostNumbers on_host(const ColumnNumbers& numbers) {
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, numbers);
}

UnitExponents exponents(const Unit& unit, int dimension, double gamma) {
  const double adiabatic = unit.adiabatic * (1 - gamma);
  return {unit.length + dimension * (unit.volume - adiabatic), unit.mass + adiabatic, unit.time};
}

std::string singular_name(const FieldFacts& facts) {
  return facts.singular ? facts.singular : facts.name;
}

HostRows::HostRows(const ColumnNumbers& numbers, int row_length, const Ids& of, int dimensions, double index)
    : order(of.extent(0)),
      data(on_host(numbers)),
      stride(static_cast<std::size_t>(row_length)),
      dimension(dimensions),
      gamma(index) {
  const auto host_ids = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, of);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return host_ids(a) < host_ids(b); });
  ids.reserve(order.size());
  for (const int i : order) ids.push_back(host_ids(i));
}

HostRows::HostRows(const HostRows& rows, const ColumnNumbers& numbers, int row_length) : HostRows(rows) {
  data = on_host(numbers);
  stride = static_cast<std::size_t>(row_length);
}

std::vector<double> HostRows::values(const FieldPlace& place) const {
  const FieldFacts& facts = *place.facts;
  const auto width = static_cast<std::size_t>(output_components(facts.rank));
  std::vector<double> values(order.size() * width, 0.0);
  for (int k = 0; k < place.components; ++k) {
    const std::size_t to = output_component(facts.rank, dimension, k);
    for (std::size_t i = 0; i < order.size(); ++i) values[i * width + to] = at(static_cast<int>(i), place.row + k);
  }
  return values;
}

Field HostRows::field(const FieldPlace& place, Written as) const {
  const FieldFacts& facts = *place.facts;
  return {std::move(as.name), std::move(as.description), exponents(facts.unit, dimension, gamma),
          output_components(facts.rank), values(place)};
}

Field HostRows::field_of(const std::shared_ptr<const HostRows>& rows, const FieldPlace& place) {
  const FieldFacts& facts = *place.facts;
  return {facts.name,
          facts.description,
          exponents(facts.unit, rows->dimension, rows->gamma),
          output_components(facts.rank),
          {},
          [rows, place] { return rows->values(place); }};
}

Field HostRows::field(const FieldPlace& place) const {
  return field(place, {place.facts->name, place.facts->description});
}

}  // namespace sphk
