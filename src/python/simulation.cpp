// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>

#include "src/engine/errors.hpp"
#include "src/python/convert.hpp"
#include "src/python/given_gas.hpp"
#include "src/scenes/initial_condition.hpp"

namespace sphk::python {

namespace {

/// Gas of arrays, checked and completed by the package: shapes (n, D) and (n,).
ParticleSet gas_of(const Rows& position, const Rows& velocity, const Numbers& mass, const Numbers& u,
                   const std::optional<Numbers>& alpha, const std::optional<Ids>& id, const std::vector<double>& lower,
                   const std::vector<double>& size, const std::vector<bool>& periodic, double time) {
  const std::size_t n = position.shape(0), D = position.shape(1);
  ParticleSet gas{.dimension = static_cast<int>(D), .box = {}, .time = time};
  std::ranges::copy(lower, gas.box.lower.begin());
  std::ranges::copy(size, gas.box.size.begin());
  std::ranges::copy(periodic, gas.box.periodic.begin());
  gas.x.resize(n);
  gas.v.resize(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t d = 0; d < D; ++d) gas.x[i][d] = position(i, d), gas.v[i][d] = velocity(i, d);
  gas.m.assign(mass.data(), mass.data() + n);
  gas.u.assign(u.data(), u.data() + n);
  if (alpha) gas.alpha.assign(alpha->data(), alpha->data() + n);
  if (id) gas.id.assign(id->data(), id->data() + n);
  return gas;
}

/// A run that Python holds. It is closed at the end of the process, since Python may hold it for longer.
struct KeptRun {
  LiveRun run;
  std::shared_ptr<void> closed = closed_at_exit([this] { run.close(); });
  ~KeptRun() {
    const std::scoped_lock alone(engine_mutex());
    run.close();
    closed.reset();
  }
};

/// Python takes what these return over.
KeptRun* run_of_gas(const ParticleSet& gas, const KeyTexts& keys, int threads, bool given_units) {
  require_engine(threads);
  return computing([&] {
    return new KeptRun{LiveRun(resolve_problem(std::make_unique<GivenGas>(gas), overrides_of(keys)), gas, given_units)};
  });
}

KeptRun* run_of_scene(const std::string& what, const KeyTexts& keys, int threads, bool given_units) {
  require_engine(threads);
  return computing([&] {
    Problem problem = resolve_problem(what, overrides_of(keys));
    const ParticleSet gas = initial_condition(*problem.scene, problem.settings);
    return new KeptRun{LiveRun(std::move(problem), gas, given_units)};
  });
}

void heed_signals() {
  if (PyErr_CheckSignals() != 0) throw nb::python_error();
}

nb::dict dict_of(const StepReport& r) {
  nb::dict report;
  report["step"] = r.step;
  report["time"] = r.time;
  report["dt"] = r.dt;
  report["updates"] = r.updates;
  report["neighbours"] = nb::make_tuple(r.min_neighbours, r.mean_neighbours, r.max_neighbours);
  report["limiting_id"] = r.limiting_id;
  return report;
}

/// Steps to a time, at most so many, and for about so many seconds of wall-clock time. Says whether it got there.
bool advance(KeptRun& kept, double until, long steps, double seconds) {
  LiveRun& run = kept.run;
  const Stopwatch watch;
  const double round_off = 1e-12 * std::abs(until - run.simulation().time());
  for (; run.simulation().time() < until - round_off; --steps) {
    if (steps == 0 || watch.wall() > seconds) return false;
    computing([&] {
      run.step(until);
      if (run.note_due()) run.note();
    });
    heed_signals();
  }
  return true;
}

nb::dict step(KeptRun& kept, double until) {
  const StepReport report = computing([&] {
    const StepReport made = kept.run.step(until);
    kept.run.note();
    return made;
  });
  heed_signals();
  return dict_of(report);
}

nb::dict totals(const KeptRun& kept) {
  const Totals t = computing([&] { return kept.run.simulation().totals(); });
  const auto D = static_cast<std::size_t>(kept.run.dimension());
  nb::dict all;
  const std::pair<const char*, double> numbers[] = {{"mass", t.mass},
                                                    {"kinetic_energy", t.kinetic},
                                                    {"thermal_energy", t.thermal},
                                                    {"potential_energy", t.potential},
                                                    {"total_energy", t.energy()},
                                                    {"heated", t.heated},
                                                    {"max_speed", t.max_speed},
                                                    {"min_rho", t.min_density},
                                                    {"max_rho", t.max_density},
                                                    {"min_P", t.min_pressure},
                                                    {"max_P", t.max_pressure}};
  for (const auto& [name, value] : numbers) all[name] = value;
  all["momentum"] = array_of(std::vector(t.momentum.begin(), t.momentum.begin() + D));
  all["angular_momentum"] = array_of(std::vector(t.angular_momentum.begin(), t.angular_momentum.end()));
  return all;
}

nb::dict costs(const KeptRun& kept) {
  const Costs c = kept.run.simulation().costs();
  nb::dict all, phases;
  for (const auto& [name, seconds] : c.phases) phases[name.c_str()] = seconds;
  all["updates"] = c.updates;
  all["pair_interactions"] = c.pair_interactions;
  all["flops"] = c.flops;
  all["bytes_per_particle"] = c.bytes_per_particle;
  all["seconds"] = phases;
  return all;
}

nb::dict history(const KeptRun& kept) {
  nb::dict columns;
  const auto& rows = kept.run.history();
  for (std::size_t k = 0; k < rows.front().size(); ++k) {
    std::vector<double> column;
    for (const History::Measures& row : rows) column.push_back(row[k].second);
    columns[rows.front()[k].first.c_str()] = array_of(std::move(column));
  }
  return columns;
}

nb::dict arrays_of(const std::map<std::string, FieldArray>& fields) {
  nb::dict arrays;
  for (const auto& [name, field] : fields) arrays[name.c_str()] = array_of(field);
  return arrays;
}

nb::dict rates(KeptRun& kept, bool split) {
  return arrays_of(computing([&] {
    std::vector<Field> fields = kept.run.simulation().rates(split);
    return kept.run.in_own_order(std::move(fields));
  }));
}

nb::dict errors(const KeptRun& kept) {
  return arrays_of(computing([&] { return kept.run.in_own_order(kept.run.simulation().errors()); }));
}

nb::ndarray<nb::numpy, const std::uint64_t> ids(const KeptRun& kept) {
  auto* const numbers = new std::vector<std::uint64_t>(computing([&] { return kept.run.simulation().held().id; }));
  const nb::capsule owner(numbers, [](void* p) noexcept { delete static_cast<std::vector<std::uint64_t>*>(p); });
  return {numbers->data(), {numbers->size()}, owner};
}

nb::dict settings(const KeptRun& kept) {
  nb::dict all;
  for (const Key& key : kept.run.problem().settings.keys())
    std::visit([&](const auto& value) { all[key.name.c_str()] = nb::cast(value); }, key.value);
  return all;
}

nb::dict place_of(const KeptRun& kept) {
  const Box& box = kept.run.box();
  nb::list lower, size, periodic;
  for (std::size_t d = 0; d < static_cast<std::size_t>(kept.run.dimension()); ++d) {
    lower.append(box.lower[d]);
    size.append(box.size[d]);
    periodic.append(bool(box.periodic[d]));
  }
  nb::dict place;
  place["lower"] = nb::tuple(lower);
  place["size"] = nb::tuple(size);
  place["periodic"] = nb::tuple(periodic);
  return place;
}

nb::list heatings(const KeptRun& kept) {
  nb::list all;
  const Problem& problem = kept.run.problem();
  for (const HeatEvent& event : problem.scene->heatings(problem.settings))
    all.append(
        nb::make_tuple(event.time, nb::make_tuple(event.place[0], event.place[1], event.place[2]), event.energy));
  return all;
}

std::vector<double> numbers_of(const std::optional<Numbers>& array) {
  return array ? std::vector(array->data(), array->data() + array->size()) : std::vector<double>();
}

void add(KeptRun& kept, const std::optional<Numbers>& velocity, const std::optional<Numbers>& energy) {
  const Gains gains{numbers_of(velocity), numbers_of(energy)};
  computing([&] { kept.run.simulation().add(gains); });
}

void heat(KeptRun& kept, const std::vector<double>& place, double energy) {
  Array3 x{};
  std::ranges::copy(place, x.begin());
  computing([&] { kept.run.simulation().heat(x, energy); });
}

}  // namespace

void bind_simulation(nb::module_& m) {
  nb::class_<ParticleSet>(m, "Gas", "Particles of an initial condition, in the engine's memory.")
      .def_prop_ro("size", &ParticleSet::size)
      .def_ro("dimension", &ParticleSet::dimension);
  m.def("gas", &gas_of, nb::arg("position"), nb::arg("velocity"), nb::arg("mass"), nb::arg("u"),
        nb::arg("alpha").none(), nb::arg("id").none(), nb::arg("lower"), nb::arg("size"), nb::arg("periodic"),
        nb::arg("time"), "Gas of arrays with shapes (n, D), (n, D), (n,), (n,), ...");
  nb::class_<KeptRun>(m, "Run", "A simulation in progress: what sphk.Simulation is made of.")
      .def("step", &step, nb::arg("until"))
      .def("advance", &advance, nb::arg("until"), nb::arg("steps"), nb::arg("seconds"))
      .def("note", [](KeptRun& h) { computing([&] { h.run.note(); }); })
      .def_prop_ro("time", [](const KeptRun& h) { return h.run.simulation().time(); })
      .def_prop_ro("step_count", [](const KeptRun& h) { return h.run.simulation().last_step().step; })
      .def_prop_ro("size", [](const KeptRun& h) { return h.run.simulation().size(); })
      .def_prop_ro("dimension", [](const KeptRun& h) { return h.run.dimension(); })
      .def_prop_ro("scene", [](const KeptRun& h) { return h.run.record().scene; })
      .def_prop_ro("warnings", [](const KeptRun& h) { return h.run.record().warnings; })
      .def_prop_ro("box", &place_of)
      .def_prop_ro("heatings", &heatings)
      .def("totals", &totals)
      .def("costs", &costs)
      .def("history", &history)
      .def("settings", &settings)
      .def("ids", &ids)
      .def("fields", [](const KeptRun& h) { return computing([&] { return h.run.fields(); }); })
      .def("field", [](const KeptRun& h,
                       const std::string& name) { return array_of(computing([&] { return h.run.field(name); })); })
      .def("rates", &rates, nb::arg("split"))
      .def("errors", &errors)
      .def("heat", &heat, nb::arg("place"), nb::arg("energy"))
      .def("add", &add, nb::arg("velocity").none(), nb::arg("energy").none())
      .def(
          "save",
          [](KeptRun& h, const std::filesystem::path& folder, bool overwrite) {
            return computing([&] { return h.run.save(folder, overwrite); });
          },
          nb::arg("folder"), nb::arg("overwrite"))
      .def("close", [](KeptRun& h) { computing([&] { h.run.close(); }); });
  m.def("run_of_gas", &run_of_gas, nb::arg("gas"), nb::arg("keys"), nb::arg("threads"), nb::arg("given_units"));
  m.def("run_of_scene", &run_of_scene, nb::arg("what"), nb::arg("keys"), nb::arg("threads"), nb::arg("given_units"));
}

}  // namespace sphk::python
