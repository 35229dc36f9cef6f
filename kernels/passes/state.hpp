// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cells/cell_tree.hpp"
#include "kernels/cells/sorter.hpp"
#include "kernels/cells/tile.hpp"
#include "kernels/passes/central_mass.hpp"
#include "kernels/passes/clock.hpp"
#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

/// What the particles of a scheme are: dimension, fields, thermal variable. Schemes that differ only in smoothing
/// kernel or pair arithmetic share a layout, and all code that knows no more of them.
template <int D, class FieldList, class Form>
struct Layout {
  static constexpr int dimension = D;
  using Fields = FieldList;
  using ThermalForm = Form;
};

/// What every scheme has, first in its columns and in this order. Code that needs no more is compiled once, for all
/// schemes.
using BaseFields = List<Position, Velocity, HalfStepVelocity, Mass, Thermal, HalfStepThermal, Heating, Support,
                        InverseSupport, NumberDensity, NumberDensitySlope, Density, Acceleration, MaxSignalVelocity>;
template <class L>
using BaseLayout = Layout<L::dimension, BaseFields, typename L::ThermalForm>;
template <class L>
inline constexpr bool is_base = std::is_same_v<typename L::Fields, BaseFields>;

/// What the loops for density and gradients know beside it: next in the columns, of those that a scheme has.
using CoreFields = List<VelocityDivergence, VelocityCurl, DensitySlope, GradVelocityDivergence>;

/// What the loops for density and gradients know of a scheme. Schemes that agree in it share these loops.
template <class L, class K, class T, class DensitySums>
struct CoreScheme {
  static constexpr int dimension = L::dimension;
  using Layout = L;
  using Fields = typename L::Fields;
  using Kernel = K;
  using PairNumber = T;
  using DensityTerms = DensitySums;
};

/// Some of the particles, or all of them. Pair loops compute those whose step ends now alone.
struct ParticleSubset {
  bool everyone = true;
  int count = 0;                                 ///< cells that hold any
  Kokkos::View<int*, MemorySpace> cell_numbers;  ///< the first `count`: those cells
  Kokkos::View<TargetMask*, MemorySpace> masks;  ///< of every cell

  template <int D>
  int cells(const CellTree<D>& tree) const {
    return everyone ? tree.cells() : count;
  }
  KOKKOS_INLINE_FUNCTION int cell(int k) const { return everyone ? k : cell_numbers(k); }
  template <int D>
  KOKKOS_INLINE_FUNCTION TargetMask targets(const CellTree<D>& tree, int cell) const {
    return everyone ? all_targets(tree, cell) : masks(cell);
  }
  KOKKOS_INLINE_FUNCTION bool contains(int i) const {
    return everyone || (masks(i / cell_size) >> (i % cell_size) & 1);
  }
};

inline constexpr Number neighbour_number{.key = "sph.neighbours",
                                         .standard = 48,
                                         .meaning = "neighbour number N_n of V_D h^D n = N_n (S12 eq 11)",
                                         .min = 1,
                                         .max = 1e6};
inline constexpr Number largest_support{
    .key = "sph.h_max",
    .standard = 0,
    .meaning = "largest support radius; 0: the diagonal of an open box, no limit that matters in a periodic one"};
inline constexpr Number courant_number{
    .key = "time.courant", .standard = 0.4, .meaning = "C of dt = C h / v_max (S12 eq 43)", .min = 1e-6, .max = 10};

/// Numbers that every scheme has, in code units.
struct Parameters {
  double neighbours = 48;  ///< N_n of S12 eq 11
  double gamma = 5.0 / 3;  ///< adiabatic index
  double courant = 0.4;    ///< C of S12 eq 43
  double h_max = 0;        ///< cap of the support radius
};

/// The particles of a run, sorted, with their cells. Copied into functors by value.
template <class L>
struct Particles {
  using Columns = sphk::Columns<L::dimension, typename L::Fields>;

  int n = 0;
  Columns columns;
  Ids ids;
  CellTree<L::dimension> tree;
  Parameters parameters;
  ParticleSubset active{};
  StepClock clock{};
  CentralMass central{};
  /// Row of the density that the equation of state and the forces take: that of a scheme's generalised continuity
  /// equation, where it has one.
  int state_density_row = component_offset<L::dimension, Density, typename L::Fields>;

  /// The same particles for code that knows more or fewer fields at the end of the columns, where their rows are.
  template <class Other>
  Particles<Other> as() const {
    static_assert(starts_with<typename L::Fields, typename Other::Fields> ||
                  starts_with<typename Other::Fields, typename L::Fields>);
    return {n, {columns.data, columns.stride}, ids, tree, parameters, active, clock, central, state_density_row};
  }

  template <class F>
  KOKKOS_FORCEINLINE_FUNCTION double& at(int i, int component = 0) const {
    return columns.template at<F>(i, component);
  }
  KOKKOS_FORCEINLINE_FUNCTION double state_density(int i) const {
    return columns.data(static_cast<std::size_t>(state_density_row) * columns.stride + i);
  }
  KOKKOS_INLINE_FUNCTION Vec<double, L::dimension> position(int i) const {
    return columns.template load<List<Position>>(i).x;
  }
  /// dt = C h_i / v_max,i (S12 eq 43), or what circling the central mass asks for.
  KOKKOS_INLINE_FUNCTION double step_asked(int i) const {
    const double asked = parameters.courant * at<Support>(i) / at<MaxSignalVelocity>(i);
    return central.limited(asked, parameters.courant, position(i));
  }
};

template <class S>
using SmoothingOf = Smoothing<typename S::Kernel, S::dimension>;

/// Particles and the smoothing kernel that pair loops need.
template <class S>
struct State : Particles<typename S::Layout> {
  SmoothingOf<S> smoothing;
};

}  // namespace sphk
