#pragma once

#include <cmath>

#include "kernels/passes/state.hpp"
#include "src/engine/particle_set.hpp"

namespace sphk {

/// Columns on the host, with the order of ids.
struct HostRows {
  std::vector<int> order;
  HostNumbers data;
  std::size_t stride;
  std::vector<std::uint64_t> ids;  ///< in order

  HostRows(const Numbers& numbers, int row_length, const Ids& of);

  /// Component `row` of the particle that is i-th by id.
  double at(int i, int row) const { return data(row * stride + order[i]); }
  /// Rows from `row` on as components of an output field, from `first` on; the other components are zero.
  Field field(std::string name, std::string description, UnitExponents units, int components, int row, int rows,
              int first) const;
};

HostNumbers on_host(const Numbers& numbers);

/// Vectors have three components in any dimension; a curl in 2D has its z alone.
template <class F>
inline constexpr bool is_vector =
    std::is_same_v<F, Position> || std::is_same_v<F, Velocity> || std::is_same_v<F, Acceleration> ||
    std::is_same_v<F, VelocityCurl> || std::is_same_v<F, GradVelocityDivergence>;

template <class L>
struct HostColumns : HostRows {
  static constexpr int D = L::dimension;
  using Fields = typename L::Fields;

  explicit HostColumns(const Particles<L>& state) : HostRows(state.columns.data, state.columns.stride, state.ids) {}
  explicit HostColumns(const HostRows& rows) : HostRows(rows) {}

  /// Component k of field F of the particle that is i-th by id.
  template <class F>
  double at(int i, int k = 0) const {
    return HostRows::at(i, component_offset<D, F, Fields> + k);
  }
  template <class F>
  Field field(std::string name, std::string description, UnitExponents units) const {
    return HostRows::field(std::move(name), std::move(description), units, is_vector<F> ? 3 : 1,
                           component_offset<D, F, Fields>, components<F, D>,
                           std::is_same_v<F, VelocityCurl> && D < 3 ? 2 : 0);
  }
  /// A field of one component, value(i) for the particle that is i-th by id.
  template <class Value>
  Field scalar(std::string name, std::string description, UnitExponents units, const Value& value) const {
    Field out{std::move(name), std::move(description), units, 1, std::vector<double>(order.size())};
    for (std::size_t i = 0; i < order.size(); ++i) out.values[i] = value(static_cast<int>(i));
    return out;
  }
};

}  // namespace sphk
