// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <memory>

#include "kernels/passes/state.hpp"
#include "src/engine/field_places.hpp"
#include "src/engine/particle_set.hpp"

namespace sphk {

/// Powers of length, mass and time in a unit, in D dimensions.
UnitExponents exponents(const Unit& unit, int dimension, double gamma);

/// How a field is written: its name, or what it is called where it is written.
struct Written {
  std::string name, description;
};

/// Columns on the host, with the order of ids.
struct HostRows {
  std::vector<int> order;
  HostNumbers data;
  std::size_t stride;
  int dimension;
  double gamma;
  std::vector<std::uint64_t> ids;  ///< in order

  HostRows(const ColumnNumbers& numbers, int row_length, const Ids& of, int dimensions, double adiabatic_index);
  /// Other columns of the same particles.
  HostRows(const HostRows& rows, const ColumnNumbers& numbers, int row_length);

  /// Component `row` of the particle that is i-th by id.
  double at(int i, int row) const { return data(row * stride + order[i]); }
  /// The values of a field as output: vectors with three components in any dimension, a curl in 2D as the z of three, a
  /// symmetric matrix as xx, yy, zz, xy, xz, yz; what there is not is zero.
  std::vector<double> values(const FieldPlace& place) const;
  /// A field as output, and the same without its values, which it makes when they are asked for: `rows` stay so long.
  Field field(const FieldPlace& place, Written as) const;
  static Field field_of(const std::shared_ptr<const HostRows>& rows, const FieldPlace& place);
  /// Under its own name.
  Field field(const FieldPlace& place) const;
  /// A field of one component, value(i) for the particle that is i-th by id.
  template <class Value>
  Field scalar(std::string name, std::string description, const Unit& unit, const Value& value) const {
    Field out{std::move(name), std::move(description), exponents(unit, dimension, gamma), 1,
              std::vector<double>(order.size())};
    for (std::size_t i = 0; i < order.size(); ++i) out.values[i] = value(static_cast<int>(i));
    return out;
  }
};

HostNumbers on_host(const ColumnNumbers& numbers);

/// The name that GADGET gives to a field of one word, where it has one.
std::string singular_name(const FieldFacts& facts);

template <class L>
struct HostColumns : HostRows {
  static constexpr int D = L::dimension;
  using Fields = typename L::Fields;

  explicit HostColumns(const Particles<L>& state)
      : HostRows(state.columns.data, state.columns.stride, state.ids, D, state.parameters.gamma) {}

  /// Component k of field F of the particle that is i-th by id.
  template <class F>
  double at(int i, int k = 0) const {
    return HostRows::at(i, component_offset<D, F, Fields> + k);
  }
};

}  // namespace sphk
