#pragma once

#include "kernels/core/values.hpp"

namespace sphk {

/// How the momentum and energy of a particle follow the mass that it exchanges.
enum class MassCorrection {
  particle,     ///< every particle keeps its own (S12 eq 39-40)
  flux,         ///< S12 eq E6 and E8
  donor,        ///< mass brings the velocity and energy of the particle that gives it; rho's change is paid for
  donor_unpaid  ///< the same without the work of rho's change
};

/// Numbers that terms and passes read, in code units; one set for a run.
struct Parameters {
  double neighbours = 48;          ///< N_n of S12 eq 11
  double gamma = 5.0 / 3;          ///< adiabatic index
  double courant = 0.4;            ///< C of S12 eq 43
  double alpha = 1, beta = 2;      ///< viscosity; alpha is S12's alpha_v where a switch multiplies it
  bool subtract_E0 = false;        ///< from the pressure force (S12 eq 18)
  double alpha_entropy = 1;        ///< S12's alpha_A
  double alpha_mass = 1;           ///< S12's alpha_m
  double alpha_min = 0.2;          ///< what the switch decays to (S12 eq 23)
  double noise = 0.05;             ///< n_s of S12 eq 21
  double alpha_given = -1;         ///< of every particle; negative: the switch decides
  bool balsara_limits_all = true;  ///< Balsara's factor multiplies every dissipation, not the viscosity alone
  MassCorrection mass_correction = MassCorrection::donor;
  double alpha_conductivity = 1;     ///< V10's alpha_u
  bool signed_conductivity = false;  ///< V10 eq 5 in place of eq 3
  bool balsara = true;               ///< Balsara's factor limits the viscosity of the classic schemes
  bool motion = true;                ///< particles move; else they keep their places and velocities
  double h_max = 0;                  ///< cap of the support radius
  double central_mass = 0;           ///< G M of a mass at the origin, which pulls all particles; 0: none
  double softening = 0;              ///< of its potential - G M / sqrt(r^2 + softening^2)
};

/// A term is a pure function of two particles' values, `term(sum, i, j, ij)`, which adds its share of the pair to i's
/// sums. It declares the fields it Reads and Adds and its flops, is made from Parameters, and is branch-free in its
/// number type.
template <class... Terms>
struct TermSet : Terms... {
  using List = sphk::List<Terms...>;
  using Reads = Union<typename Terms::Reads...>;
  using Adds = Union<typename Terms::Adds...>;
  static constexpr int flops = (0 + ... + Terms::flops);

  explicit TermSet(const Parameters& parameters) : Terms(parameters)... {}

  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    (static_cast<const Terms&>(*this)(sum, i, j, ij), ...);
  }
};

/// Base of terms without numbers of their own.
struct PlainTerm {
  PlainTerm() = default;
  explicit PlainTerm(const Parameters&) {}
};

}  // namespace sphk
