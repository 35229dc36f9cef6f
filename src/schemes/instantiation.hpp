#pragma once

#include <memory>
#include <string>
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
  std::vector<const Number*> numbers;  ///< of its terms and passes
  std::vector<FieldPlace> written;     ///< by its passes, whether or not anyone reads them
  const char* left_out;                ///< what the thermal variable makes unnecessary; null: nothing
};

using Instantiations = std::vector<Instantiation>;

/// Rows of scheme S in D dimensions. Defined in instantiate.hpp; one source file each.
template <class S, int D>
Instantiations instantiate();

/// Those of every scheme of the list (src/schemes/CMakeLists.txt), which writes this function.
Instantiations all_instantiations();

}  // namespace sphk
