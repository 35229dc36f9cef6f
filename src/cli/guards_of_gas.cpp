#include <fmt/format.h>

#include <limits>

#include "src/cli/commands.hpp"
#include "src/cli/guards.hpp"
#include "src/cli/plain_file.hpp"
#include "src/scenes/block.hpp"

namespace sphk {

namespace {

using Outcomes = std::vector<Outcome>;
constexpr std::size_t row = 7;  // of the particle that is spoiled: id 8
constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();

Outcomes not_numbers(const Workshop& shop) {
  const std::pair<const char*, double& (*)(ParticleSet&)> datasets[] = {
      {"Coordinates", [](ParticleSet& gas) -> double& { return gas.x[row][1]; }},
      {"Velocities", [](ParticleSet& gas) -> double& { return gas.v[row][2]; }},
      {"Masses", [](ParticleSet& gas) -> double& { return gas.m[row]; }},
      {"InternalEnergies", [](ParticleSet& gas) -> double& { return gas.u[row]; }},
      {"SmoothingLengths", [](ParticleSet& gas) -> double& { return gas.h[row]; }}};
  std::vector<Command> commands;
  for (const auto& [dataset, value] : datasets)
    for (const double wrong : {nan, infinity, -infinity}) {
      const std::string name = fmt::format("{}-{}.hdf5", dataset, wrong);
      commands.push_back({run_of_gas(shop, name, [wrong, value = value](ParticleSet& gas) { value(gas) = wrong; }),
                          ExitCode::bad_input,
                          {name, dataset, fmt::format("row {} (from 0) is {}", row, wrong), "mend the file"}});
    }
  return {try_commands("exit 2: file, dataset, row, value", commands, shop)};
}

Outcomes signs(const Workshop& shop) {
  const auto refused = [&](const std::string& name, const char* problem,
                           const std::function<void(ParticleSet&)>& change) {
    return Command{run_of_gas(shop, name, change), ExitCode::bad_input, {name, "mended", problem, "row 7 (id 8)"}};
  };
  const auto runs = [&](const std::string& name, const char* note, const std::function<void(ParticleSet&)>& change) {
    return Command{run_of_gas(shop, name, change), ExitCode::done, {note}};
  };
  return {
      try_commands("exit 2: file, row, id, place",
                   {refused("m-negative.hdf5", "zero or negative mass", [](auto& gas) { gas.m[row] = -1; }),
                    refused("m-zero.hdf5", "zero or negative mass", [](auto& gas) { gas.m[row] = 0; }),
                    refused("u-negative.hdf5", "negative specific thermal energy", [](auto& gas) { gas.u[row] = -1; }),
                    refused("h-negative.hdf5", "negative smoothing length", [](auto& gas) { gas.h[row] = -1; })},
                   shop),
      try_commands(
          "h = 0 is found; u = 0 runs",
          {runs("h-zero.hdf5", "smoothing lengths of 0 (1 of 216) will be found", [](auto& gas) { gas.h[row] = 0; }),
           runs("h-zeros.hdf5", "they will be found", [](auto& gas) { gas.h.assign(gas.size(), 0); }),
           runs("u-zero.hdf5", "complete", [](auto& gas) { gas.u[row] = 0; }),
           runs("u-zeros.hdf5", "complete", [](auto& gas) { gas.u.assign(gas.size(), 0); })},
          shop)};
}

Outcomes adiabatic_indices(const Workshop& shop) {
  std::vector<ExtremeCase> cases;
  for (const char* gamma : {"1.0001", "5"})
    cases.push_back({fmt::format("gamma-{}", gamma),
                     "",
                     "sod",
                     {{"scene.dimension", "1"}, {"scene.n", "64"}, {"sph.scheme", "gadget2"}, {"sph.gamma", gamma}},
                     {{"energy", 1e-3}, {"momentum", 1e-6}}});
  std::vector<Command> refused;
  for (const char* gamma : {"1", "0.9", "-1", "0", "nan", "inf"})
    refused.push_back(
        {{"run", "sod", "--set", fmt::format("sph.gamma={}", gamma), "--out", shop.path("run"), "--overwrite"},
         ExitCode::bad_input,
         {fmt::format("--set sph.gamma={}", gamma), "must lie between 1.0000001 and 100"}});
  Outcomes outcomes = perform_all(cases, shop);
  outcomes.push_back(try_commands("exit 2 for gamma <= 1: key, range", refused, shop));
  return outcomes;
}

Outcomes vanishing_steps(const Workshop& shop) {
  const auto stuck = [&](const std::string& name, const std::vector<std::string>& more,
                         const std::vector<std::string>& says, const std::function<void(ParticleSet&)>& change) {
    Command command{
        run_of_gas(shop, name, change, more), ExitCode::numerics, {"step 0, t = ", "the particle with id "}};
    command.says.insert(command.says.end(), says.begin(), says.end());
    return command;
  };
  const auto late = [](ParticleSet& gas) { gas.time = 0.01; };  // t = 0 grows with any step
  const auto fast = [&](double v) { return [=](ParticleSet& gas) { late(gas), gas.v[row][0] = v; }; };
  const auto hot = [&](double u) { return [=](ParticleSet& gas) { late(gas), gas.u[row] = u; }; };
  const std::vector<std::string> in_double{"--precision", "double"}, own_steps{"--set", "time.steps=individual"};
  return {try_commands("exit 3: step, time, id, place, remedy",
                       {stuck("fast.hdf5", in_double, {"too short to change the time", "time.courant"}, fast(1e18)),
                        stuck("hot.hdf5", {}, {"too short to change the time", "time.courant"}, hot(1e36)),
                        stuck("hot-own.hdf5", own_steps, {"below the shortest one", "output.snapshots"}, hot(1e36)),
                        stuck("faster.hdf5", {}, {"not a positive number", "sph.precision"}, fast(1e20))},
                       shop)};
}

Outcomes few_particles(const Workshop& shop) {
  const auto some = [](std::size_t n, bool periodic) {
    return [=](ParticleSet& gas) {
      for (auto* column : {&gas.m, &gas.u, &gas.h}) column->resize(n);
      for (auto* column : {&gas.x, &gas.v}) column->resize(n);
      gas.box.periodic.fill(periodic);
    };
  };
  return {try_commands("exit 2 without particles",
                       {{run_of_gas(shop, "none.hdf5", some(0, true)),
                         ExitCode::bad_input,
                         {"none.hdf5", "no gas particles", "at least one"}}},
                       shop),
          try_commands("10 in an open box: runs, note",
                       {{run_of_gas(shop, "open.hdf5", some(10, false)),
                         ExitCode::done,
                         {"asked of 10 particles without periodic images", "sph.neighbours"}}},
                       shop),
          try_commands("10 in a periodic box: runs",
                       {{run_of_gas(shop, "periodic.hdf5", some(10, true)),
                         ExitCode::done,
                         {"complete"},
                         {"without periodic images"}}},
                       shop)};
}

}  // namespace

ParticleSet even_gas(int dimension) {
  ParticleSet gas;
  gas.dimension = dimension;
  gas.x = lattice_points({.dimension = dimension, .counts = even_counts(dimension, 6)});
  for (int axis = 0; axis < dimension; ++axis) gas.box.periodic[axis] = true;
  gas.v.assign(gas.size(), {});
  gas.m.assign(gas.size(), 1 / static_cast<double>(gas.size()));
  gas.u.assign(gas.size(), 1.5);
  gas.h.assign(gas.size(), 0.4);
  return gas;
}

std::vector<std::string> run_of_gas(const Workshop& shop, const std::string& name,
                                    const std::function<void(ParticleSet&)>& change,
                                    const std::vector<std::string>& more, int dimension) {
  ParticleSet gas = even_gas(dimension);
  change(gas);
  write_plain_file(shop.path(name), gas);
  std::vector<std::string> words{"run", shop.path(name), "--out", shop.path("run"), "--overwrite", "--t-end",
                                 "0.1", "--steps",       "2"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::vector<Trial> guards_of_gas() {
  return {{"guard-nan", "NaN, Inf, -Inf in each dataset", not_numbers},
          {"guard-signs", "zero and negative m, u, h", signs},
          {"guard-gamma", "gamma 1.0001 and 5; 1 and below", adiabatic_indices},
          {"guard-step", "steps that do not change the time", vanishing_steps},
          {"guard-few", "fewer particles than neighbours", few_particles}};
}

}  // namespace sphk
