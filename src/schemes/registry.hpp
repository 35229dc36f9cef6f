#pragma once

#include <memory>
#include <string>
#include <vector>

#include "src/engine/settings.hpp"
#include "src/engine/simulation.hpp"

namespace sphk {

/// The schemes that a user may ask for: all but "glass", which relaxes initial conditions.
std::vector<std::string> scheme_names();
std::vector<std::string> kernel_names();

/// Declares the keys of the sections [sph], [viscosity] and [time] that every run has.
void declare_engine_keys(Settings& settings);
SimulationSettings simulation_settings(const Settings& settings);

/// Smallest N_n for which S12 eq 11 has a root: V_D N_D w(0), the self term alone.
double min_neighbours(const std::string& kernel, int dimension);

/// Of the compiled scheme that serves these particles.
SchemeDescription describe(const SimulationSettings& settings, const ParticleSet& particles);

/// Checks the particles and the settings (InputError), loads the device and computes the first density and rates.
std::unique_ptr<Simulation> make_simulation(const ParticleSet& particles, const SimulationSettings& settings);

}  // namespace sphk
