// SPDX-License-Identifier: BSD-3-Clause
#include "src/python/live_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "kernels/core/fields.hpp"
#include "src/engine/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/python/given_gas.hpp"
#include "src/report/run_json.hpp"
#include "src/schemes/registry.hpp"

namespace sphk::python {

namespace fs = std::filesystem;

/// A folder that snapshots go to.
struct LiveRun::Folder {
  RunFolder taken;
  Settings settings;
  RunOutput output;
  Folder(RunFolder&& folder, const Scene& scene, Settings of_run)
      : taken(std::move(folder)), settings(std::move(of_run)), output(taken.path, scene, settings) {}
};

LiveRun::LiveRun(Problem problem, const ParticleSet& gas, bool given_units)
    : problem_(std::move(problem)), given_units_(given_units), box_(gas.box) {
  const Stopwatch watch;
  SimulationSettings settings = method();
  if (given_units) settings.own_units = Scale{};
  simulation_ = make_simulation(gas, settings);
  record_ = make_record(problem_, gas);
  record_.setup_seconds = watch.wall();
  done_.begin = simulation_->time();
  start_ = simulation_->totals();
  note();
}

SimulationSettings LiveRun::method() const {
  return simulation_settings(problem_.settings);
}

Simulation& LiveRun::simulation() const {
  if (!simulation_) throw InputError("this simulation is closed: make another");
  return *simulation_;
}

StepReport LiveRun::step(double until) {
  const Stopwatch watch;
  const StepReport report = simulation().step(until);
  done_.wall += watch.wall();
  done_.cpu += watch.cpu();
  ++done_.steps;
  updates_ += static_cast<std::size_t>(report.updates);
  return report;
}

void LiveRun::note() {
  if (noted_ == simulation().time()) return;
  const Totals now = simulation().totals();
  StepReport step = simulation().last_step();
  step.time = simulation().time();
  history_.push_back(standard_columns(step, now, drift(start_, now, box_)));
  noted_ = step.time;
  updates_ = 0;
}

std::vector<std::string> LiveRun::fields() const {
  std::vector<std::string> names;
  for (const Field& field : simulation().view().fields) names.push_back(field.name);
  return names;
}

FieldArray LiveRun::field(const std::string& name) const {
  const HeldParticles held = simulation().held();
  const auto own = std::ranges::find(held.fields, name, &HeldField::name);
  if (own != held.fields.end() && given_units_)
    return {.data = own->data,
            .n = held.id.size(),
            .components = static_cast<std::size_t>(own->components),
            .component_stride = own->stride,
            .rows = own->components > 1 || is_vector(name),
            .memory = held.memory};
  const Snapshot view = simulation().view();
  if (std::ranges::find(view.fields, name, &Field::name) == view.fields.end())
    throw InputError(fmt::format("there is no field \"{}\"; there are {}", name, fmt::join(fields(), ", ")));
  return array_of(view.field(name), held.id);
}

/// In 1D its components do not tell.
bool LiveRun::is_vector(const std::string& name) const {
  if (dimension() > 1) return false;
  const Snapshot view = simulation().view();
  return std::ranges::find(view.fields, name, &Field::name)->components > 1;
}

std::map<std::string, FieldArray> LiveRun::in_own_order(std::vector<Field> fields) const {
  const std::vector<std::uint64_t> ids = simulation().held().id;
  std::map<std::string, FieldArray> arrays;
  for (Field& field : fields) {
    arrays.emplace(field.name, array_of(field, ids));
    field.values = {};
  }
  return arrays;
}

FieldArray LiveRun::array_of(const Field& field, const std::vector<std::uint64_t>& ids) const {
  std::vector<std::size_t> order(ids.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return ids[i]; });
  const auto given = static_cast<std::size_t>(field.components);
  const auto kept = given == 3 ? static_cast<std::size_t>(dimension()) : given;  // vectors are padded to three
  const bool axial = field.name == VelocityCurl::facts.name && dimension() == 2;
  const auto values = std::make_shared<std::vector<double>>(ids.size() * (axial ? 1 : kept));
  const std::size_t width = axial ? 1 : kept, first = axial ? 2 : 0;
  for (std::size_t k = 0; k < order.size(); ++k)
    for (std::size_t c = 0; c < width; ++c) (*values)[order[k] * width + c] = field.values[k * given + first + c];
  return {values->data(), ids.size(), width, width, 1, given > 1 && !axial, values};
}

fs::path LiveRun::save(const fs::path& asked, bool overwrite) {
  const fs::path place = fs::absolute(asked).lexically_normal();
  auto found = folders_.find(place);
  if (found == folders_.end()) {
    Settings settings = problem_.settings;
    settings.set("time.end", simulation().time(), Origin::file);
    const bool given = dynamic_cast<const GivenGas*>(problem_.scene) != nullptr;
    if (given) settings.set(GivenGas::file_key, std::string("snap_0000.hdf5"), Origin::file);
    auto folder = std::make_shared<Folder>(
        make_run_folder(problem_.scene->name(), {.asked = place, .overwrite = overwrite}), *problem_.scene, settings);
    found = folders_.emplace(place, std::move(folder)).first;
  }
  RunOutput& output = found->second->output;
  output.write(simulation());
  RunRecord record = record_;
  record.finished = true;
  add_results(record, done_, output, simulation(), box_);
  write_atomically(place / "run.json", run_json(record));
  return place;
}

}  // namespace sphk::python
