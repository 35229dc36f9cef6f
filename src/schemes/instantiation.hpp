// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "src/engine/scheme_interface.hpp"
#include "src/schemes/scheme_facts.hpp"

namespace sphk {

/// A term of a compiled recipe, for code that does not know its type.
struct TermFacts {
  const char* name;
  bool (*idle)(const Given&, const GasTraits&);  ///< whether it has nothing to add
};

/// One compiled recipe: what it is called, what it serves and how it is made. The rows of the one table that run time
/// chooses from.
struct Instantiation {
  const SchemeFacts* scheme;
  const char* energy;  ///< entropy | energy
  int dimension;
  const char* precision;  ///< mixed | double
  const char* kernel;     ///< null: any, through the table
  bool complete;          ///< every term and pass of the scheme
  double flops;           ///< of a pair
  double self_term;       ///< V_D N_D w(0): the neighbours that a particle alone counts; 0 through the table
  bool (*serves)(const Given&, const GasTraits&);
  std::unique_ptr<Simulation> (*make)(const ParticleSet&, const SimulationSettings&);
  CompiledFacts (*facts)();
  std::vector<TermFacts> terms;
  std::vector<FieldPlace> written;  ///< by its passes, whether or not anyone reads them
  const char* left_out;             ///< what the thermal variable makes unnecessary; null: nothing
};

using Instantiations = std::vector<Instantiation>;

/// Rows of scheme S in D dimensions with pairs in T (float or double). Defined in instantiate.hpp; a source file each.
template <class S, int D, class T>
Instantiations instantiate();

/// All rows of scheme S in D dimensions.
template <class S, int D>
Instantiations rows_of() {
  Instantiations rows = instantiate<S, D, float>();
  std::ranges::move(instantiate<S, D, double>(), std::back_inserter(rows));
  return rows;
}

}  // namespace sphk
