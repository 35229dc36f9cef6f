#include <fmt/format.h>

#include <algorithm>

#include "src/cli/commands.hpp"
#include "src/cli/file_scene.hpp"
#include "src/cli/platform.hpp"
#include "src/cli/run_folder.hpp"
#include "src/cli/run_loop.hpp"
#include "src/cli/stop_signal.hpp"
#include "src/engine/errors.hpp"
#include "src/io/reader.hpp"
#include "src/report/final_table.hpp"
#include "src/report/run_json.hpp"
#include "src/report/text_file.hpp"
#include "src/scenes/initial_condition.hpp"
#include "src/schemes/registry.hpp"
#include "src/stability/verdict.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

RunLoop::Plan make_plan(const Settings& settings, double begin, double walltime) {
  const RunLoop::Plan plan{.end = settings.real("time.end"),
                           .steps = settings.integer("time.max_steps"),
                           .snapshots = settings.integer("output.snapshots"),
                           .checkpoint = settings.real("output.checkpoint"),
                           .walltime = walltime};
  if (!(plan.end > begin))
    throw InputError(fmt::format("time.end = {} is not after the start at t = {}: give the end time with --t-end T",
                                 plan.end, begin));
  return plan;
}

/// What is known before the first step.
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
  record.left_out = description.left_out;
  if (const auto* file = dynamic_cast<const FileScene*>(problem.scene)) record.warnings = file->remarks();
  const std::string remark = stability_remark(s.kernel, s.neighbours, particles.dimension, s.gamma);
  if (!remark.empty()) record.warnings.push_back(remark);
  const auto periodic = std::ranges::count(particles.box.periodic, true);
  if (periodic == 0 && s.neighbours > static_cast<double>(particles.size()))
    record.warnings.push_back(
        fmt::format("{:g} neighbours are asked of {} particles without periodic images: supports reach over nearly "
                    "all of them; sph.neighbours sets the number",
                    s.neighbours, particles.size()));
  const auto [least, most] = std::ranges::minmax(particles.m);
  if ((s.scheme == "gadget2" || s.scheme == "v10") && most > 1.01 * least)
    record.warnings.push_back(
        fmt::format("{} conserves energy for particles of equal masses only, and these differ by a "
                    "factor {:.3g}: sph, tsph and osph take any masses, sphs exchanges them",
                    s.scheme, most / least));
  return record;
}

std::string headline(const RunRecord& r) {
  return fmt::format(
      "sphk {}: {} with {} particles in {}D; {} on {}, {} threads, {} precision; scheme {}, kernel {}, {:g} "
      "neighbours",
      r.build.version, r.scene, r.particles, r.dimension, r.platform.backend, r.platform.device, r.platform.threads,
      r.platform.precision, r.scheme, r.kernel, r.neighbours);
}

void add_results(RunRecord& record, const RunLoop& loop, const RunOutput& output, const Simulation& simulation,
                 const Box& box) {
  record.steps = loop.state().steps;
  record.time = simulation.time();
  record.wall_seconds = loop.state().wall;
  record.cpu_seconds = loop.state().cpu;
  record.joules = loop.state().joules;
  record.output_seconds = output.seconds();
  record.costs = simulation.costs();
  record.conservation = drift(output.start(), simulation.totals(), box);
  record.errors = output.errors();
  record.deviations = output.deviations().by_measure();
  record.budget = output.budget();
  for (const std::string& warning : simulation.warnings())
    if (std::ranges::find(record.warnings, warning) == record.warnings.end()) record.warnings.push_back(warning);
}

std::string closing_words(const RunRecord& record, const RunOutput& output) {
  const std::string folder = output.folder().string();
  if (record.finished) return fmt::format("{} is complete; see it with: sphk plot {}", folder, folder);
  return fmt::format("stopped at t = {:.6g}, after step {}; go on with: sphk run --resume {}", record.time,
                     record.steps, folder);
}

/// The run that a folder's newest checkpoint holds, its particles as make_simulation wants them.
ParticleSet particles_of(const SavedRun& saved) {
  ParticleSet particles = read_particles(saved.file).particles;
  particles.box = saved.box;
  return particles;
}

std::string scene_file_of(const fs::path& folder) {
  const fs::path file = folder / "scene.used.toml";
  if (!fs::exists(file))
    throw InputError(fmt::format("{} holds no run: name a folder that `sphk run` filled", folder.string()));
  return file.string();
}

}  // namespace

int run_command(const RunOptions& options) {
  const Problem problem = options.resume ? resolve_problem(scene_file_of(*options.resume), {})
                                         : resolve_problem(options.what, options.overrides);
  if (options.dry_run) return dry_run_command(problem);
  if (options.out && !options.overwrite) refuse_used_folder(*options.out);
  const Stopwatch setup;
  std::optional<SavedRun> saved;
  if (options.resume) saved = newest_checkpoint(*options.resume, *problem.scene, problem.settings);
  const ParticleSet particles = saved ? particles_of(*saved) : initial_condition(*problem.scene, problem.settings);
  const double begin = saved ? saved->loop.begin : particles.time;
  RunLoop::Plan plan = make_plan(problem.settings, begin, options.walltime);
  RunRecord record = make_record(problem, particles);
  Progress progress(options.json_log ? ProgressStyle::json : style_for(stdout),
                    {.from = begin, .to = plan.end, .steps = plan.steps});
  progress.say(headline(record));
  if (saved) {
    record.warnings.insert(record.warnings.end(), saved->remarks.begin(), saved->remarks.end());
    progress.say(fmt::format("goes on from {}, step {}", saved->file.string(), saved->loop.steps));
  }
  for (const std::string& remark : record.warnings) progress.say("note: " + remark);
  const auto simulation = make_simulation(particles, simulation_settings(problem.settings));
  if (saved) simulation->restore(saved->simulation);
  record.setup_seconds = setup.wall();

  catch_stop_signals();
  RunOutput output = saved ? RunOutput(*options.resume, *problem.scene, problem.settings, saved->output)
                           : RunOutput(make_run_folder(problem.scene->name(), options.out, options.overwrite),
                                       *problem.scene, problem.settings);
  Checkpoints checkpoints(output.folder(), saved ? saved->file : fs::path());
  plan.rows = output.deviations().times(begin, plan.end);
  plan.heatings = problem.scene->heatings(problem.settings);
  RunLoop loop(*simulation, output, checkpoints, progress, plan, particles.box);
  if (saved) loop.resume(saved->loop);
  const auto conclude = [&] {
    add_results(record, loop, output, *simulation, particles.box);
    write_text(output.folder() / "run.json", run_json(record));
  };
  try {
    record.finished = loop.run() == RunLoop::End::finished;
  } catch (const NumericsError& error) {
    record.warnings.push_back(error.what());
    conclude();
    throw NumericsError(fmt::format("{}\nThe run until then is in {}, its last snapshot is {}", error.what(),
                                    output.folder().string(), output.last_snapshot()));
  } catch (const InputError& error) {  // an output that cannot be written
    if (!checkpoints.any()) throw;
    throw InputError(fmt::format("{}\nThen go on with: sphk run --resume {}", error.what(), output.folder().string()));
  }
  conclude();
  if (record.finished) checkpoints.remove();
  if (!options.json_log) progress.say("\n" + final_table(record));
  progress.say(closing_words(record, output));
  return record.finished ? ExitCode::done : ExitCode::stopped;
}

}  // namespace sphk
