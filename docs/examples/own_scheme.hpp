// SPDX-License-Identifier: BSD-3-Clause

// A smoothing kernel, a field, a term with a number, a scheme and a scene of one's own.
#pragma once

#include <cmath>
#include <numbers>
#include <sphk_scheme.hpp>

using namespace sphk;

/// w(q) = (1-q)^3.
struct Cubed {
  static constexpr const char* name = "cubed";
  static constexpr double spacings = 2.5;  // usual support radius, in distances of particles
  static constexpr int flops = 5;
  template <class T>
  KOKKOS_INLINE_FUNCTION Shape<T> operator()(T q) const {  // float, double or a SIMD pack; zero for q >= 1
    const T s = truncated(lane_t<T>(1), q);
    return {s * s * s, lane_t<T>(-3) * s * s};
  }
  KOKKOS_INLINE_FUNCTION constexpr double norm(int D) const { return norm_from_moment(D, power_moment(3, D, 1)); }
};

/// A field that snapshots show.
struct Mixing {
  static constexpr FieldFacts facts{.name = "Mixing",
                                    .description = "sum_j m_j |v_ij| Wbar",
                                    .unit = {.length = 1, .mass = 1, .time = -1, .volume = -1},
                                    .shown = Shown::in_snapshots};
  template <class T, int D>
  struct Value {
    T mixing;
  };
};

/// Friction between neighbours: dv_i/dt = - k sum_j m_j v_ij Wbar, and the heat that it makes.
struct Friction {
  static constexpr Number k{.key = "friction.k", .standard = 1, .meaning = "strength of the friction"};
  static constexpr const char* name = "friction between neighbours";
  using Numbers = sphk::Numbers<k>;
  using Reads = List<Position, InverseSupport, Mass, Velocity>;
  using Adds = List<Acceleration, Heating, Mixing>;
  static constexpr int flops = 20;
  double strength;
  explicit Friction(const Given& given) : strength(given[k]) {}
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(i.m)>;
    using T = lane_t<P>;
    const auto v_ij = i.v - j.v;
    const P rate = P(T(strength)) * j.m * ij.W, v2 = dot(v_ij, v_ij);
    sum.a -= rate * v_ij;
    sum.du = sum.du + P(T(0.5)) * rate * v2;
    sum.mixing = sum.mixing + j.m * sphk::sqrt(v2) * ij.W;
  }
};

/// SPH with friction in place of viscosity, in 1D.
struct Rubbing {
  static constexpr SchemeFacts facts{.name = "rubbing", .summary = "SPH with friction", .usual = {{{"cubed", 5}}}};
  struct Entropy : Recipe<EntropyForm, DivergenceSum, TermSet<PressureGradientSph, Friction, SignalVelocity>,
                          Step<StateEquation>> {
    using Kernels = ByDimension<List<Cubed>, List<>, List<>>;
  };
  using Recipes = List<Entropy>;
};

/// A standing wave in a periodic tube.
struct StandingWave : Scene {
  std::string name() const override { return "standing-wave"; }
  std::string summary() const override { return "sound in a tube"; }
  void declare(Settings& settings) const override { declare_resolution(settings, 100); }
  int dimension(const Settings&) const override { return 1; }
  ParticleSet build(const Settings& settings) const override {
    const int n = scene_n(settings);
    ParticleSet gas{.dimension = 1, .box = {.periodic = {true, false, false}}};
    for (int i = 0; i < n; ++i) {
      gas.x.push_back({(i + 0.5) / n, 0, 0});
      gas.v.push_back({0.01 * std::sin(2 * std::numbers::pi * gas.x[i][0]), 0, 0});
    }
    gas.m.assign(gas.size(), 1.0 / n);
    gas.u.assign(gas.size(), 1);
    return gas;
  }
};
