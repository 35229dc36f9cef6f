#pragma once

#include <memory>
#include <string>
#include <vector>

#include "src/engine/simulation.hpp"

namespace sphk {

/// Which particles a compiled scheme serves.
enum class Masses { any, equal };

/// One compiled scheme: what it is called and how it is made. The rows of the one table that run time chooses from.
struct Instantiation {
  std::string scheme;  ///< the name that users give
  std::string energy;  ///< entropy | energy
  int dimension;
  std::string precision;  ///< mixed | double
  std::string kernel;     ///< empty: any, through the table
  Masses masses;
  std::unique_ptr<Simulation> (*make)(const ParticleSet&, const SimulationSettings&);
  SchemeDescription (*describe)();
};

using Instantiations = std::vector<Instantiation>;

// One source file each.
Instantiations sph_entropy_1d(), sph_entropy_2d(), sph_entropy_3d();
Instantiations sph_energy_1d(), sph_energy_2d(), sph_energy_3d();
Instantiations tsph_1d(), tsph_2d(), tsph_3d();
Instantiations tsph_energy();
Instantiations osph_1d(), osph_2d(), osph_3d(), osph_energy(), osph_coherent();
Instantiations v10_1d(), v10_2d(), v10_3d();

Instantiations gadget2_1d(), gadget2_2d(), gadget2_3d();
Instantiations sphs_1d(), sphs_2d(), sphs_3d();
Instantiations sphs_multi_1d(), sphs_multi_2d(), sphs_multi_3d();
Instantiations sphs_energy_1d(), sphs_energy_2d(), sphs_energy_3d();
Instantiations sphs_energy_multi_1d(), sphs_energy_multi_2d(), sphs_energy_multi_3d();
Instantiations sphs_conservative_1d(), sphs_conservative_2d(), sphs_conservative_3d();
Instantiations sphs_rt();
Instantiations glass();

}  // namespace sphk
