#pragma once

#include "kernels/core/type_list.hpp"
#include "kernels/core/vec.hpp"

namespace sphk {

/// A field is a tag with a member template `Value<T, D>` that holds its symbol, as a number, a pack or a vector of
/// them. Powers of length, mass and time in its unit are given for 3D.
struct Position {
  static constexpr const char* name = "Coordinates";
  static constexpr bool relative = true;  ///< pair loops hold it relative to a nearby origin
  template <class T, int D>
  struct Value {
    Vec<T, D> x;
  };
};

/// x_i - x_j of the pair that a particle is the j of.
struct Separation {
  static constexpr const char* name = "Separations";
  template <class T, int D>
  struct Value {
    Vec<T, D> r_ij;
  };
};

/// |x_i - x_j|^2.
struct Distance2 {
  static constexpr const char* name = "SquaredDistances";
  template <class T, int D>
  struct Value {
    T r2;
  };
};

/// Velocity at the current time (predicted between the two kicks).
struct Velocity {
  static constexpr const char* name = "Velocities";
  static constexpr bool relative = true;
  template <class T, int D>
  struct Value {
    Vec<T, D> v;
  };
};

/// Velocity at the middle of the step (kick-drift-kick).
struct HalfStepVelocity {
  static constexpr const char* name = "HalfStepVelocities";
  template <class T, int D>
  struct Value {
    Vec<T, D> v_half;
  };
};

struct Mass {
  static constexpr const char* name = "Masses";
  template <class T, int D>
  struct Value {
    T m;
  };
};

/// The thermal variable that the scheme integrates: the entropy function A = P / rho^gamma or the specific energy u.
struct Thermal {
  static constexpr const char* name = "Thermal";
  template <class T, int D>
  struct Value {
    T s;
  };
};

struct HalfStepThermal {
  static constexpr const char* name = "HalfStepThermal";
  template <class T, int D>
  struct Value {
    T s_half;
  };
};

/// d(thermal variable)/dt.
struct ThermalRate {
  static constexpr const char* name = "ThermalRate";
  template <class T, int D>
  struct Value {
    T ds;
  };
};

/// Support radius: the kernel is zero for r >= h.
struct Support {
  static constexpr const char* name = "SmoothingLength";
  template <class T, int D>
  struct Value {
    T h;
  };
};

struct InverseSupport {
  static constexpr const char* name = "InverseSmoothingLength";
  template <class T, int D>
  struct Value {
    T h_inv;
  };
};

/// n_i = sum_j W(r_ij, h_i), self included (S12 eq 11).
struct NumberDensity {
  static constexpr const char* name = "NumberDensities";
  template <class T, int D>
  struct Value {
    T n;
  };
};

/// dn/dh at fixed positions.
struct NumberDensitySlope {
  static constexpr const char* name = "NumberDensitySlopes";
  template <class T, int D>
  struct Value {
    T dn_dh;
  };
};

/// rho_i = sum_j m_j W(r_ij, h_i) (S12 eq 6).
struct Density {
  static constexpr const char* name = "Densities";
  template <class T, int D>
  struct Value {
    T rho;
  };
};

struct DensitySlope {
  static constexpr const char* name = "DensitySlopes";
  template <class T, int D>
  struct Value {
    T drho_dh;
  };
};

struct InverseDensity {
  static constexpr const char* name = "InverseDensities";
  template <class T, int D>
  struct Value {
    T rho_inv;
  };
};

struct Pressure {
  static constexpr const char* name = "Pressures";
  template <class T, int D>
  struct Value {
    T P;
  };
};

/// P / rho^2.
struct PressureOverDensity2 {
  static constexpr const char* name = "PressuresOverDensities2";
  template <class T, int D>
  struct Value {
    T P_rho2;
  };
};

/// z of the conservative momentum equation for any masses (EQUATIONS, Momentum): the term that h's gradient adds to m.
struct GradHMass {
  static constexpr const char* name = "GradHMasses";
  template <class T, int D>
  struct Value {
    T z;
  };
};

struct SoundSpeed {
  static constexpr const char* name = "SoundSpeeds";
  template <class T, int D>
  struct Value {
    T c;
  };
};

struct VelocityDivergence {
  static constexpr const char* name = "VelocityDivergence";
  template <class T, int D>
  struct Value {
    T div_v;
  };
};

struct VelocityCurl {
  static constexpr const char* name = "VelocityCurl";
  template <class T, int D>
  struct Value {
    Vec<T, curl_size<D>> curl_v;
  };
};

/// Balsara's factor |div v| / (|div v| + |curl v| + 1e-4 c/h) (S12 eq 32).
struct Balsara {
  static constexpr const char* name = "BalsaraFactors";
  template <class T, int D>
  struct Value {
    T balsara;
  };
};

/// grad(div v).
struct GradVelocityDivergence {
  static constexpr const char* name = "GradVelocityDivergence";
  template <class T, int D>
  struct Value {
    Vec<T, D> grad_div_v;
  };
};

/// alpha of the convergence switch (S12 eq 21-23), in [0, 1], before Balsara's factor.
struct Alpha {
  static constexpr const char* name = "Alpha";
  template <class T, int D>
  struct Value {
    T alpha;
  };
};

/// alpha_i as the viscosity uses it, with Balsara's factor.
struct ViscosityAlpha {
  static constexpr const char* name = "ViscosityAlpha";
  template <class T, int D>
  struct Value {
    T alpha_v;
  };
};

/// alpha_i as the dissipation of entropy and mass uses it.
struct DissipationAlpha {
  static constexpr const char* name = "DissipationAlpha";
  template <class T, int D>
  struct Value {
    T alpha_d;
  };
};

struct HalfStepMass {
  static constexpr const char* name = "HalfStepMasses";
  template <class T, int D>
  struct Value {
    T m_half;
  };
};

/// dm/dt by mass dissipation.
struct MassRate {
  static constexpr const char* name = "MassRate";
  template <class T, int D>
  struct Value {
    T dm;
  };
};

/// Momentum that exchanged mass brings, against the velocity of the particle that gains it.
struct MassMomentum {
  static constexpr const char* name = "MassMomentumRate";
  template <class T, int D>
  struct Value {
    Vec<T, D> dm_v;
  };
};

/// Energy that exchanged mass brings, against the energy of the particle that gains it.
struct MassEnergy {
  static constexpr const char* name = "MassEnergyRate";
  template <class T, int D>
  struct Value {
    T dm_e;
  };
};

/// sum_j (dm_j/dt) W(r_ij, h_i): how the exchange of mass changes the density.
struct MassDensityRate {
  static constexpr const char* name = "MassDensityRate";
  template <class T, int D>
  struct Value {
    T dm_W;
  };
};

struct Acceleration {
  static constexpr const char* name = "Acceleration";
  template <class T, int D>
  struct Value {
    Vec<T, D> a;
  };
};

/// du/dt by dissipation and, where the scheme integrates u, by compression.
struct Heating {
  static constexpr const char* name = "Heating";
  template <class T, int D>
  struct Value {
    T du;
  };
};

/// Largest signal velocity over the neighbours, at least 2 c_i (the self pair).
struct MaxSignalVelocity {
  static constexpr const char* name = "MaxSignalVelocities";
  static constexpr bool is_maximum = true;
  template <class T, int D>
  struct Value {
    T v_sig;
  };
};

/// Neighbours with r < h_i, self included.
struct NeighbourCount {
  static constexpr const char* name = "NeighbourCount";
  template <class T, int D>
  struct Value {
    T count;
  };
};

}  // namespace sphk
