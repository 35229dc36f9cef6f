#pragma once

#include "src/cli/trials.hpp"
#include "src/engine/particle_set.hpp"

namespace sphk {

/// Even gas at rest in a periodic box: density 1, and the pressure 1 of gamma = 5/3.
ParticleSet even_gas(int dimension = 3);

/// `sphk run FILE` for two steps, of even gas that is changed before it is written.
std::vector<std::string> run_of_gas(const Workshop& shop, const std::string& name,
                                    const std::function<void(ParticleSet&)>& change,
                                    const std::vector<std::string>& more = {}, int dimension = 3);

/// Values of particles, their number, the adiabatic index, steps.
std::vector<Trial> guards_of_gas();
/// Disks, folders, files and checkpoints.
std::vector<Trial> guards_of_files();

/// Rates of thin periodic slabs against those of the same gas laid out side by side, so that each neighbour counts
/// once.
std::vector<Outcome> compare_slabs(const Workshop& shop);

}  // namespace sphk
