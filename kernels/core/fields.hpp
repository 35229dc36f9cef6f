// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/core/field_facts.hpp"
#include "kernels/core/type_list.hpp"
#include "kernels/core/vec.hpp"

namespace sphk {

// A field is a tag: its facts, and a member template `Value<T, D>` that holds its symbol, as a number, a pack or a
// vector of them.

struct Position {
  static constexpr FieldFacts facts{.name = "Coordinates",
                                    .description = "Position",
                                    .unit = {.length = 1},
                                    .rank = Rank::vector,
                                    .relative = Relative::place};
  template <class T, int D>
  struct Value {
    Vec<T, D> x;
  };
};

/// x_i - x_j of the pair that a particle is the j of.
struct Separation {
  static constexpr FieldFacts facts{.name = "Separations",
                                    .description = "x_i - x_j of the pair that a particle is the j of",
                                    .unit = {.length = 1},
                                    .rank = Rank::vector};
  template <class T, int D>
  struct Value {
    Vec<T, D> r_ij;
  };
};

/// |x_i - x_j|^2.
struct Distance2 {
  static constexpr FieldFacts facts{.name = "SquaredDistances", .description = "|x_i - x_j|^2", .unit = {.length = 2}};
  template <class T, int D>
  struct Value {
    T r2;
  };
};

/// Velocity at the current time (predicted between the two kicks).
struct Velocity {
  static constexpr FieldFacts facts{.name = "Velocities",
                                    .description = "Velocity",
                                    .unit = {.length = 1, .time = -1},
                                    .rank = Rank::vector,
                                    .relative = Relative::motion};
  template <class T, int D>
  struct Value {
    Vec<T, D> v;
  };
};

/// Velocity at the middle of the step (kick-drift-kick).
struct HalfStepVelocity {
  static constexpr FieldFacts facts{.name = "HalfStepVelocities",
                                    .description = "Velocity at the middle of the step",
                                    .unit = {.length = 1, .time = -1},
                                    .rank = Rank::vector};
  template <class T, int D>
  struct Value {
    Vec<T, D> v_half;
  };
};

struct Mass {
  static constexpr FieldFacts facts{.name = "Masses", .description = "Mass", .unit = {.mass = 1}};
  template <class T, int D>
  struct Value {
    T m;
  };
};

/// The thermal variable that the scheme integrates: the entropy function A = P / rho^gamma or the specific energy u.
struct Thermal {
  static constexpr FieldFacts facts{.name = "Thermal", .description = "A or u, whichever is integrated"};
  template <class T, int D>
  struct Value {
    T s;
  };
};

struct HalfStepThermal {
  static constexpr FieldFacts facts{.name = "HalfStepThermal", .description = "A or u at the middle of the step"};
  template <class T, int D>
  struct Value {
    T s_half;
  };
};

/// Support radius: the kernel is zero for r >= h.
struct Support {
  static constexpr FieldFacts facts{.name = "SmoothingLength",
                                    .description = "Support radius: W = 0 for r >= h",
                                    .unit = {.length = 1},
                                    .shown = Shown::in_rates};
  template <class T, int D>
  struct Value {
    T h;
  };
};

struct InverseSupport {
  static constexpr FieldFacts facts{.name = "InverseSmoothingLength", .description = "1/h", .unit = {.length = -1}};
  template <class T, int D>
  struct Value {
    T h_inv;
  };
};

/// n_i = sum_j W(r_ij, h_i), self included (S12 eq 11).
struct NumberDensity {
  static constexpr FieldFacts facts{
      .name = "NumberDensities", .description = "n_i = sum_j W(r_ij, h_i)", .unit = {.volume = -1}};
  template <class T, int D>
  struct Value {
    T n;
  };
};

/// dn/dh at fixed positions.
struct NumberDensitySlope {
  static constexpr FieldFacts facts{
      .name = "NumberDensitySlopes", .description = "dn/dh at fixed positions", .unit = {.length = -1, .volume = -1}};
  template <class T, int D>
  struct Value {
    T dn_dh;
  };
};

/// rho_i = sum_j m_j W(r_ij, h_i) (S12 eq 6).
struct Density {
  static constexpr FieldFacts facts{.name = "Densities",
                                    .description = "Density, sum of m_j W(r_ij, h_i)",
                                    .unit = {.mass = 1, .volume = -1},
                                    .shown = Shown::in_rates,
                                    .singular = "Density"};
  template <class T, int D>
  struct Value {
    T rho;
  };
};

struct DensitySlope {
  static constexpr FieldFacts facts{.name = "DensitySlopes",
                                    .description = "drho/dh at fixed positions",
                                    .unit = {.length = -1, .mass = 1, .volume = -1}};
  template <class T, int D>
  struct Value {
    T drho_dh;
  };
};

struct InverseDensity {
  static constexpr FieldFacts facts{
      .name = "InverseDensities", .description = "1/rho", .unit = {.mass = -1, .volume = 1}};
  template <class T, int D>
  struct Value {
    T rho_inv;
  };
};

struct Pressure {
  static constexpr FieldFacts facts{
      .name = "Pressures", .description = "Pressure", .unit = {.length = 2, .mass = 1, .time = -2, .volume = -1}};
  template <class T, int D>
  struct Value {
    T P;
  };
};

/// P / rho^2.
struct PressureOverDensity2 {
  static constexpr FieldFacts facts{.name = "PressuresOverDensities2",
                                    .description = "P/rho^2",
                                    .unit = {.length = 2, .mass = -1, .time = -2, .volume = 1}};
  template <class T, int D>
  struct Value {
    T P_rho2;
  };
};

/// z of the conservative momentum equation for any masses (EQUATIONS, Momentum): the term that h's gradient adds to m.
struct GradHMass {
  static constexpr FieldFacts facts{
      .name = "GradHMasses", .description = "z of the conservative forces", .unit = {.mass = 1}};
  template <class T, int D>
  struct Value {
    T z;
  };
};

struct SoundSpeed {
  static constexpr FieldFacts facts{
      .name = "SoundSpeeds", .description = "Speed of sound", .unit = {.length = 1, .time = -1}};
  template <class T, int D>
  struct Value {
    T c;
  };
};

struct VelocityDivergence {
  static constexpr FieldFacts facts{
      .name = "VelocityDivergence", .description = "div v", .unit = {.time = -1}, .shown = Shown::in_snapshots};
  template <class T, int D>
  struct Value {
    T div_v;
  };
};

struct VelocityCurl {
  static constexpr FieldFacts facts{.name = "VelocityCurl",
                                    .description = "curl v",
                                    .unit = {.time = -1},
                                    .rank = Rank::axial,
                                    .shown = Shown::in_rates};
  template <class T, int D>
  struct Value {
    Vec<T, curl_size<D>> curl_v;
  };
};

/// Balsara's factor |div v| / (|div v| + |curl v| + 1e-4 c/h) (S12 eq 32).
struct Balsara {
  static constexpr FieldFacts facts{
      .name = "BalsaraFactors", .description = "Balsara factor", .shown = Shown::in_snapshots};
  template <class T, int D>
  struct Value {
    T balsara;
  };
};

/// grad(div v).
struct GradVelocityDivergence {
  static constexpr FieldFacts facts{.name = "GradVelocityDivergence",
                                    .description = "grad(div v)",
                                    .unit = {.length = -1, .time = -1},
                                    .rank = Rank::vector,
                                    .shown = Shown::in_rates};
  template <class T, int D>
  struct Value {
    Vec<T, D> grad_div_v;
  };
};

/// alpha of the convergence switch (S12 eq 21-23), in [0, 1], before Balsara's factor.
struct Alpha {
  static constexpr FieldFacts facts{.name = "Alpha",
                                    .description = "Dissipation switch (S12 eq 21-23), before Balsara's factor",
                                    .shown = Shown::in_snapshots};
  template <class T, int D>
  struct Value {
    T alpha;
  };
};

/// alpha_i as the viscosity uses it, with Balsara's factor.
struct ViscosityAlpha {
  static constexpr FieldFacts facts{.name = "ViscosityAlpha",
                                    .description = "alpha of the viscosity, with Balsara's factor",
                                    .shown = Shown::in_snapshots};
  template <class T, int D>
  struct Value {
    T alpha_v;
  };
};

/// alpha_i as the dissipation of entropy and mass uses it.
struct DissipationAlpha {
  static constexpr FieldFacts facts{.name = "DissipationAlpha",
                                    .description = "alpha of the dissipation of entropy and mass"};
  template <class T, int D>
  struct Value {
    T alpha_d;
  };
};

struct HalfStepMass {
  static constexpr FieldFacts facts{
      .name = "HalfStepMasses", .description = "Mass at the middle of the step", .unit = {.mass = 1}};
  template <class T, int D>
  struct Value {
    T m_half;
  };
};

/// dm/dt by mass dissipation.
struct MassRate {
  static constexpr FieldFacts facts{.name = "MassRate",
                                    .description = "dm/dt by mass dissipation",
                                    .unit = {.mass = 1, .time = -1},
                                    .shown = Shown::in_rates};
  template <class T, int D>
  struct Value {
    T dm;
  };
};

/// Momentum that exchanged mass brings, against the velocity of the particle that gains it.
struct MassMomentum {
  static constexpr FieldFacts facts{.name = "MassMomentumRate",
                                    .description = "Momentum of exchanged mass",
                                    .unit = {.length = 1, .mass = 1, .time = -2},
                                    .rank = Rank::vector};
  template <class T, int D>
  struct Value {
    Vec<T, D> dm_v;
  };
};

/// Energy that exchanged mass brings, against the energy of the particle that gains it.
struct MassEnergy {
  static constexpr FieldFacts facts{.name = "MassEnergyRate",
                                    .description = "Energy of exchanged mass",
                                    .unit = {.length = 2, .mass = 1, .time = -3}};
  template <class T, int D>
  struct Value {
    T dm_e;
  };
};

/// sum_j (dm_j/dt) W(r_ij, h_i): how the exchange of mass changes the density.
struct MassDensityRate {
  static constexpr FieldFacts facts{.name = "MassDensityRate",
                                    .description = "drho/dt by exchanged mass",
                                    .unit = {.mass = 1, .time = -1, .volume = -1}};
  template <class T, int D>
  struct Value {
    T dm_W;
  };
};

struct Acceleration {
  static constexpr FieldFacts facts{.name = "Acceleration",
                                    .description = "dv/dt of all terms",
                                    .unit = {.length = 1, .time = -2},
                                    .rank = Rank::vector,
                                    .shown = Shown::in_rates};
  template <class T, int D>
  struct Value {
    Vec<T, D> a;
  };
};

/// du/dt by dissipation and, where the scheme integrates u, by compression. The closing kick leaves d/dt of the thermal
/// variable in its place.
struct Heating {
  static constexpr FieldFacts facts{
      .name = "Heating", .description = "du/dt of all terms", .unit = {.length = 2, .time = -3}};
  template <class T, int D>
  struct Value {
    T du;
  };
};

/// Largest signal velocity over the neighbours, at least 2 c_i (the self pair).
struct MaxSignalVelocity {
  static constexpr FieldFacts facts{.name = "MaxSignalVelocities",
                                    .description = "Largest signal velocity",
                                    .unit = {.length = 1, .time = -1},
                                    .maximum = true};
  template <class T, int D>
  struct Value {
    T v_sig;
  };
};

/// Neighbours with r < h_i, self included.
struct NeighbourCount {
  static constexpr FieldFacts facts{
      .name = "NeighbourCount", .description = "Neighbours with r < h, self included", .shown = Shown::in_rates};
  template <class T, int D>
  struct Value {
    T count;
  };
};

}  // namespace sphk
