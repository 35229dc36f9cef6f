// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "src/engine/errors.hpp"
#include "src/engine/scaled_simulation.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/reader.hpp"
#include "src/report/run_json.hpp"
#include "src/run/platform.hpp"
#include "src/run/run_folder.hpp"
#include "src/run/run_loop.hpp"
#include "src/run/stop_signal.hpp"
#include "src/run/trial_gas.hpp"
#include "src/run/watch.hpp"
#include "src/scenes/initial_condition.hpp"
#include "src/schemes/registry.hpp"
#include "src/schemes/resolve.hpp"
#include "src/stability/remarks.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

/// Where a run begins: at its initial condition, or at the checkpoint of a run that goes on.
struct Start {
  std::optional<SavedRun> saved;
  ParticleSet particles;
  double begin = 0;  ///< the time at which the run began
};

Start start_of(const RunRequest& request, const Problem& problem) {
  if (!request.resume) {
    require_memory(*problem.scene, problem.settings);
    Start start{std::nullopt, initial_condition(*problem.scene, problem.settings)};
    start.begin = start.particles.time;
    return start;
  }
  Start start{newest_checkpoint(*request.resume, *problem.scene, problem.settings), {}};
  start.particles = read_particles(start.saved->file).particles;
  start.particles.box = start.saved->box;
  start.begin = start.saved->loop.begin;
  restore_files(*request.resume, *start.saved);
  return start;
}

RunLoop::Plan make_plan(const Settings& settings, double begin, double walltime) {
  const long limit = settings.integer("time.max_steps");
  const RunLoop::Plan plan{.end = settings.real("time.end"),
                           .steps = std::max(limit, 0L),
                           .snapshots = limit == 0 ? 0 : settings.integer("output.snapshots"),
                           .checkpoint = settings.real("output.checkpoint"),
                           .walltime = walltime,
                           .max_drift = settings.real("time.max_drift")};
  if (!(plan.end > begin))
    throw InputError(fmt::format("time.end = {} is not after the start at t = {}: give the end time with --t-end T",
                                 plan.end, begin));
  return plan;
}

}  // namespace

RunRecord make_record(const Problem& problem, const ParticleSet& particles) {
  const SimulationSettings s = simulation_settings(problem.settings);
  const SchemeDescription description = describe(s, particles);
  RunRecord record;
  record.scene = problem.scene->name();
  record.scheme = s.scheme;
  record.kernel = s.kernel;
  record.neighbours = s.neighbours;
  record.n = problem.settings.has("scene.n") ? problem.settings.integer("scene.n") : 0;
  record.particles = particles.size();
  record.dimension = particles.dimension;
  record.platform = detect_platform(s.precision);
  record.build = build();
  record.provenance = provenance();
  record.left_out = description.left_out;
  record.costs.bytes_per_particle = description.bytes_per_particle;
  record.warnings = input_remarks(problem);
  const KernelPair pair{s.kernel, s.neighbours};
  const auto& [kernel, neighbours] =
      scheme_entry(s.scheme).facts->usual[static_cast<std::size_t>(particles.dimension - 1)];
  const bool own_choice = s.kernel != kernel || s.neighbours != neighbours;
  for (const std::string& remark :
       {own_choice ? stability_remark(s.kernel, s.neighbours, particles.dimension, s.gamma) : "",
        sampling_remark(pair, {kernel, neighbours}, particles.dimension),
        courant_remark(s.courant, pair, particles.dimension, s.gamma)})
    if (!remark.empty()) record.warnings.push_back(remark);
  for (const std::string& remark : limits_met(problem, particles)) record.warnings.push_back(remark);
  const auto periodic = std::ranges::count(particles.box.periodic, true);
  if (periodic == 0 && s.neighbours > static_cast<double>(particles.size()))
    record.warnings.push_back(
        fmt::format("{:g} neighbours are asked of {} particles without periodic images: supports reach over nearly "
                    "all of them; sph.neighbours sets the number",
                    s.neighbours, particles.size()));
  return record;
}

void add_results(RunRecord& record, const LoopState& done, const RunOutput& output, const Simulation& simulation,
                 const Box& box) {
  record.steps = done.steps;
  record.time = simulation.time();
  record.wall_seconds = done.wall;
  record.cpu_seconds = done.cpu;
  record.joules = done.joules;
  record.output_seconds = output.seconds();
  record.costs = simulation.costs();
  record.counts = simulation.counts();
  record.peak_memory_bytes = peak_memory_bytes();
  record.conservation = drift(output.start(), simulation.totals(), box);
  record.errors = output.errors();
  record.deviations = output.deviations().by_measure();
  record.budget = output.budget();
  if (record.conservation.energy > 0.05)
    record.warnings.push_back(
        fmt::format("the energy has drifted by {:.1f} %: a smaller time.courant or another scheme may keep it",
                    100 * record.conservation.energy));
  for (const std::string& warning : simulation.warnings())
    if (std::ranges::find(record.warnings, warning) == record.warnings.end()) record.warnings.push_back(warning);
}

namespace {

std::string headline(const RunRecord& r) {
  return fmt::format(
      "sphk {}: {} with {} particles in {}D; {} on {}, {} thread{}, {} precision; scheme {}, kernel {}, {:g} "
      "neighbours",
      r.build.version, r.scene, r.particles, r.dimension, r.platform.backend, r.platform.device, r.platform.threads,
      r.platform.threads == 1 ? "" : "s", r.platform.precision, r.scheme, r.kernel, r.neighbours);
}

/// The problem of a run's folder. A scene file that has lost its end is taken from the newest checkpoint.
Problem problem_of_run(const fs::path& folder) {
  const fs::path file = folder / "scene.used.toml";
  const std::optional<SavedScene> saved = newest_scene(folder);
  if (!fs::exists(file) && !saved)
    throw InputError(fmt::format("{} holds no run: name a folder that `sphk run` filled", folder.string()));
  if (!saved) return resolve_problem(file.string(), {});
  const std::string text = text_of_file(file);
  return resolve_run(SceneFile(file, is_cut_short(text, saved->text) ? saved->text : text), saved->file);
}

FolderRequest wanted_folder(const RunRequest& request, const Settings& settings) {
  return {request.out, request.overwrite, settings.has("scene.file") ? settings.text("scene.file") : ""};
}

/// The first lines: what runs, where from, and what is remarkable about it.
void introduce(Progress& progress, const RunRecord& record, const Start& start) {
  progress.say(headline(record));
  if (start.saved)
    progress.say(fmt::format("goes on from {}, step {}", start.saved->file.string(), start.saved->loop.steps));
  for (const std::string& remark : record.warnings) progress.say("note: " + remark);
}

/// Runs the loop to its end, then calls `conclude`; so it does where the numbers go wrong. What failed is told with
/// where the run until then is, or how it goes on.
bool finishes(RunLoop& loop, const RunOutput& output, const Checkpoints& checkpoints, RunRecord& record,
              const std::function<void()>& conclude) {
  const std::string folder = output.folder().string();
  try {
    record.finished = loop.run() == RunLoop::End::finished;
  } catch (const NumericsError& error) {
    record.warnings.emplace_back(error.what());
    conclude();
    throw NumericsError(fmt::format("{}\nThe run until then is in {}, its last snapshot is {}", error.what(), folder,
                                    output.last_snapshot()));
  } catch (const InputError& error) {  // an output that cannot be written
    if (!checkpoints.any()) throw;
    throw InputError(fmt::format("{}\nThen go on with: sphk run --resume {}", error.what(), folder));
  }
  conclude();
  return record.finished;
}

}  // namespace

Problem problem_of(const RunRequest& request) {
  return request.resume ? problem_of_run(*request.resume) : resolve_problem(request.what, request.overrides);
}

RunResult run(const RunRequest& request) {
  const Stopwatch watch;
  const Problem problem = problem_of(request);
  const Scene& scene = *problem.scene;
  const Settings& settings = problem.settings;
  const FolderRequest wanted = wanted_folder(request, settings);
  std::optional<RunFolder> folder;
  if (request.resume) folder.emplace(take_run_folder(*request.resume));
  if (!request.resume) refuse_used_folder(wanted);
  Start start = start_of(request, problem);
  RunLoop::Plan plan = make_plan(settings, start.begin, request.walltime);
  RunRecord record = make_record(problem, start.particles);
  if (start.saved) std::ranges::copy(start.saved->remarks, std::back_inserter(record.warnings));
  Progress progress(request.progress, {.from = start.begin, .to = plan.end, .steps = plan.steps});
  introduce(progress, record, start);
  SimulationSettings method = simulation_settings(settings);
  if (start.saved) method.own_units = scale_of(start.saved->simulation);
  require_memory(static_cast<double>(record.particles), record.costs.bytes_per_particle);
  const auto simulation = make_simulation(start.particles, method);
  const Box box = start.particles.box;
  start.particles = {};
  if (start.saved) simulation->restore(std::exchange(start.saved->simulation, {}));
  record.setup_seconds = watch.wall();

  if (request.stop_on_signals) catch_stop_signals();
  if (!folder) folder.emplace(make_run_folder(scene.name(), wanted));
  RunOutput output(folder->path, scene, settings, start.saved ? &start.saved->output : nullptr);
  Checkpoints checkpoints(output.folder(), start.saved ? start.saved->file : fs::path());
  plan.rows = output.deviations().times(start.begin, plan.end);
  plan.heatings = scene.heatings(settings);
  if (plan.walltime > 0) plan.walltime = std::max(1e-9, plan.walltime - watch.wall());
  RunLoop loop(*simulation, output, checkpoints, progress, plan, box);
  if (start.saved) loop.resume(start.saved->loop);
  std::optional<Watch> picture;
  if (request.watch > 0) picture.emplace(output, progress, request.watch, scene.plot_hint(settings).map);
  if (picture) loop.each_step([&] { picture->look(*simulation); });
  const auto conclude = [&] {
    add_results(record, loop.state(), output, *simulation, box);
    write_atomically(output.folder() / "run.json", run_json(record));
  };
  if (finishes(loop, output, checkpoints, record, conclude)) {
    sync_to_disk(output.folder() / "history.csv");  // until now the checkpoint holds it
    checkpoints.remove();
    if (picture) picture->finish(*simulation);
  }
  return {record, output.folder()};
}

}  // namespace sphk
