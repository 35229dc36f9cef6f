// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kernels/core/number.hpp"
#include "src/engine/particle_set.hpp"
#include "src/engine/saved_state.hpp"
#include "src/engine/scale.hpp"

namespace sphk {

/// What SimulationSettings::steps may be.
inline constexpr const char *own_steps = "individual", *global_steps = "global";

/// How a run computes. What is left empty, zero or out is the scheme's own (src/schemes/resolve.hpp).
struct SimulationSettings {
  std::string scheme = "sph";       ///< any name of scheme_names()
  std::string kernel;               ///< any name of kernel_names()
  std::string precision = "mixed";  ///< mixed (float pairs, double state) | double
  std::string energy;               ///< entropy | energy: the thermal variable that is integrated
  double neighbours = 0;            ///< N_n of S12 eq 11
  double gamma = 5.0 / 3;
  double courant = 0;
  std::string steps;         ///< own_steps (powers of two) | global_steps
  bool step_limiter = true;  ///< steps of neighbours stay within a factor 4
  double h_max = 0;          ///< cap of the support radius; 0: none but the box
  double max_dt = 0;         ///< 0: no cap
  Given numbers;             ///< of terms and passes, by key, such as {"viscosity.alpha", 0.5}
  bool all_terms = false;    ///< terms that are idle are computed as well
  /// Of a run that goes on from a saved state: scale_of(saved). Else the run chooses.
  std::optional<Scale> own_units{};
};

/// Conserved sums and extremes over all particles, at the current time.
struct Totals {
  double mass = 0, kinetic = 0, thermal = 0;
  double potential = 0;  ///< of the gas and the central mass
  double heated = 0;     ///< energy that Simulation::heat and add have added
  Array3 momentum{}, angular_momentum{};
  double momentum_sizes = 0, angular_momentum_sizes = 0;  ///< sums of m |v| and m |x cross v|
  double max_speed = 0;
  double min_density = 0, max_density = 0, min_pressure = 0, max_pressure = 0, min_entropy = 0, max_entropy = 0;
  double energy() const { return kinetic + thermal + potential; }
};

/// What the last step did.
struct StepReport {
  long step = 0;
  double time = 0, dt = 0;
  long updates = 0;                                                    ///< particles whose rates were computed
  double min_neighbours = 0, mean_neighbours = 0, max_neighbours = 0;  ///< true neighbours, self included
  std::uint64_t limiting_id = 0;                                       ///< the particle that set dt
  Array3 limiting_x{};
};

/// Running costs since the start, set-up excluded.
struct Costs {
  long updates = 0;
  double pair_interactions = 0;   ///< pairs inside the support, as seen by the rates pass
  double flops = 0;               ///< counted from the terms' declarations, on pairs inside the support
  double bytes_per_particle = 0;  ///< device memory
  std::vector<std::pair<std::string, double>> phases;  ///< name, seconds, in the order of a step
};

/// What a run has had to make do with until now, over all particles and steps.
struct Counts {
  long bisections = 0;     ///< searches for h that needed the safety net
  long capped = 0;         ///< that ended at the largest support radius
  long crowded = 0;        ///< among coincident particles, more than neighbours asked
  long failed = 0;         ///< that did not converge
  long linear_fits = 0;    ///< of velocity gradients, in place of second order
  long sph_estimates = 0;  ///< in place of a fit
  long softened_heat = 0;  ///< kicks that would have taken more than half of a particle's thermal variable
  long softened_mass = 0;  ///< or mass
};

/// Energy that the particle nearest to a place takes in at once.
struct HeatEvent {
  double time = 0;
  Array3 place{};
  double energy = 0;
};

/// A field where a run holds it: component k of particle i at data[k * stride + i], in the run's own units.
struct HeldField {
  std::string name;
  UnitExponents units;
  int components = 1;
  double factor = 1;  ///< to the user's units
  const double* data = nullptr;
  std::size_t stride = 0;
};

/// Particles in the run's own order, along its curve through space, which a step may change: their ids, and the fields
/// that it holds itself. On hosts these are the run's memory, not a copy, which stays for as long as `memory` does;
/// what it holds is that of now until the next step. Positions may lie a step outside of a periodic box. Without fields
/// while some particles are in the middle of their steps.
struct HeldParticles {
  std::vector<std::uint64_t> id;
  std::vector<HeldField> fields;
  std::shared_ptr<const void> memory;
};

/// What particles take in at once, in the order of HeldParticles; empty: nothing.
struct Gains {
  std::vector<double> velocity;  ///< as many numbers a particle as there are dimensions
  std::vector<double> energy;    ///< specific
};

/// A run in progress. Created by make_simulation (src/schemes/registry.hpp).
class Simulation {
 public:
  virtual ~Simulation() = default;
  /// Advances by one time-step, cut short so that it never passes `t_end`. Throws NumericsError.
  virtual StepReport step(double t_end) = 0;
  /// Adds the energy to the particle nearest to the place, now. Every particle's step ends, and all begin anew with the
  /// shortest step that any of them asks for. Throws NumericsError.
  virtual void heat(const Array3& place, double energy) = 0;
  virtual double time() const = 0;
  virtual std::size_t size() const = 0;
  virtual Totals totals() const = 0;
  virtual Costs costs() const = 0;
  virtual StepReport last_step() const = 0;
  /// Everything to the host, sorted by id.
  Snapshot snapshot() const;
  /// The same but for the values of the fields, which are made when they are asked for: they are those of now until the
  /// next step, and must be asked for before that, while the simulation is there.
  virtual Snapshot view() const = 0;
  /// One right-hand side at the current state, as `sphk rates` writes it: SmoothingLength, Density, VelocityDivergence,
  /// VelocityCurl, Acceleration, EntropyRate, NeighbourCount, the fields of errors(), ...; with `split` each term apart
  /// as well.
  virtual std::vector<Field> rates(bool split) = 0;
  /// Leading errors of the scheme's equations at the current state, by id: E0 (3), R and V (xx, yy, zz, xy, xz, yz; R10
  /// eq 28-30), EntropyContrast (largest |ln(A_i/A_j)| over neighbours) and NearestNeighbour (distance).
  virtual std::vector<Field> errors() const = 0;
  /// All that the next steps depend on; a simulation made of the same scheme, settings, box and number of particles
  /// goes on from it bit by bit, on the same number of threads. restore() throws InputError where it does not fit.
  SavedState save() const;
  /// The same block by block: one is in memory at a time.
  virtual void save(const TakeBlock& take) const = 0;
  void restore(const SavedState& state);
  virtual void restore(const GiveBlock& give) = 0;
  virtual Counts counts() const = 0;
  /// Adds to the velocities and specific energies of all particles, now; steps end and begin as with heat(). Throws
  /// InputError where the gains are not those of so many particles, NumericsError where an energy would fall below
  /// zero.
  virtual void add(const Gains& gains) = 0;
  virtual HeldParticles held() const = 0;
  /// Sentences the user should read once: what counts() tells.
  std::vector<std::string> warnings() const;
};

/// What a scheme consists of, for `sphk show` and run.json.
struct SchemeDescription {
  std::string scheme, kernel, precision;
  int dimension = 3;
  bool tabulated = false;  ///< the kernel is not on the scheme's curated list and runs through the table
  std::vector<std::string> passes, terms, fields, left_out;
  std::vector<std::string> idle;  ///< terms that add nothing and are computed all the same
  double bytes_per_particle = 0;
  double flops_per_pair = 0;
};

}  // namespace sphk
