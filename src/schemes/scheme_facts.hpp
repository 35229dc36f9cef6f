// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "src/engine/simulation.hpp"

namespace sphk {

/// A smoothing kernel and a neighbour number that belong together.
struct KernelChoice {
  const char* kernel;
  double neighbours;
};

/// Those in 1D, 2D and 3D.
using KernelChoices = std::array<KernelChoice, 3>;
/// R10's and S12's HOCT4 with 442 in 3D; elsewhere Wendland's kernels, since a lattice samples HOCT4 badly with as wide
/// a support in 1D and 2D (its density is 3 % off in 1D), and WC6 grows shear layers closer to converged grid runs.
inline constexpr KernelChoices wide_kernels{{{"wc4", 10}, {"wc6", 100}, {"hoct4", 442}}};

/// All that is true of a scheme beside its recipes.
struct SchemeFacts {
  const char* name;     ///< what users call it
  const char* summary;  ///< one line, with its paper
  KernelChoices usual{{{"cs", 5}, {"cs", 20}, {"cs", 48}}};
  double courant = 0.2;  ///< S12's
  const char* steps = global_steps;
  const char* mixing_energy = "entropy";  ///< the thermal variable for flows that mix gases
  const char* r10_label = nullptr;        ///< as in R10's SPH-CS-128
  const char* s12_label = nullptr;        ///< as in S12's SPH-CS42
  const char* label_suffix = "";          ///< behind its neighbour number, as the e of SPHS-CT128e
  const char* differs = nullptr;          ///< from the paper
  bool hidden = false;                    ///< stands behind something else that users ask for
};

}  // namespace sphk
