#pragma once

#include "src/engine/engine.hpp"

/// Compiles what base.hpp and step_passes.hpp declare for a dimension and thermal variable.
#define SPHK_COMPILE_BASE(D, FORM) \
  namespace sphk { \
  using Base##D##FORM = Layout<D, BaseFields, FORM>; \
  template void sort_cells(Particles<Base##D##FORM>&, Sorter<D>&, Schedule&, long); \
  template void fit_cells(const Particles<Base##D##FORM>&); \
  template long mark_active(Particles<Base##D##FORM>&); \
  template void assign_steps(const Particles<Base##D##FORM>&, const Schedule&, Ticks); \
  template void wake_all(const Particles<Base##D##FORM>&); \
  template Ticks first_end(const Particles<Base##D##FORM>&); \
  template void count_neighbours(const Particles<Base##D##FORM>&, const CountColumns<D>&, StepReport&); \
  template Totals totals(const Particles<Base##D##FORM>&); \
  template Run<Base##D##FORM> load_run(const ParticleSet&, const SimulationSettings&, const SchemeFacts&, const std::function<void(Run<Base##D##FORM>&)>&); \
  template std::unique_ptr<Simulation> make_run(const ParticleSet&, const SimulationSettings&, std::unique_ptr<SchemePasses<Base##D##FORM>>); \
  }
