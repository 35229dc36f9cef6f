#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/cli/commands.hpp"
#include "src/cli/guards.hpp"
#include "src/cli/plain_file.hpp"
#include "src/engine/errors.hpp"
#include "src/io/hdf5_file.hpp"
#include "src/scenes/block.hpp"
#include "src/scenes/random.hpp"

namespace sphk {

namespace {

constexpr double spacing = 1.0 / 16;  // it and whatever is added to it are exact, so that copies are exact too
constexpr double tolerance = 1e-12;

double exact_in_sums(double x) {
  return std::round(x * 0x1p40) * 0x1p-40;
}

/// Periodic gas of so many particles along each axis, with uneven places, masses, velocities and energies.
ParticleSet uneven_gas(const Counts& counts) {
  Uniform uniform(1);
  const auto shift = [&] { return 2 * uniform() - 1; };
  Block block{.dimension = 3, .counts = counts};
  ParticleSet gas;
  gas.box.periodic = {true, true, true};
  for (int axis = 0; axis < 3; ++axis) gas.box.size[axis] = block.size[axis] = counts[axis] * spacing;
  gas.x = lattice_points(block);
  for (Array3& x : gas.x) {
    for (int axis = 0; axis < 3; ++axis)
      x[axis] = wrapped(exact_in_sums(x[axis] + 0.2 * spacing * shift()), gas.box.size[axis]);
    gas.v.push_back({shift(), shift(), shift()});
    gas.m.push_back((1 + 0.1 * shift()) * spacing * spacing * spacing);
    gas.u.push_back(1 + 0.2 * shift());
  }
  return gas;
}

/// Copies of the gas side by side; particle i of each is i modulo the number of particles.
ParticleSet laid_out(const ParticleSet& gas, const Counts& copies) {
  ParticleSet all;
  all.box = gas.box;
  for (int axis = 0; axis < 3; ++axis) all.box.size[axis] *= copies[axis];
  for (int a = 0; a < copies[0]; ++a)
    for (int b = 0; b < copies[1]; ++b)
      for (int c = 0; c < copies[2]; ++c)
        for (std::size_t i = 0; i < gas.size(); ++i) {
          const Array3& x = gas.x[i];
          all.x.push_back({x[0] + a * gas.box.size[0], x[1] + b * gas.box.size[1], x[2] + c * gas.box.size[2]});
          all.v.push_back(gas.v[i]);
          all.m.push_back(gas.m[i]);
          all.u.push_back(gas.u[i]);
        }
  return all;
}

/// The file that `sphk rates` writes for gas; throws where it fails.
hdf5::File rates_of(const ParticleSet& gas, const std::string& name, const std::string& scheme, const Workshop& shop) {
  const std::string out = shop.path(name + "-rates.hdf5"), log = shop.path(name + ".log");
  write_plain_file(shop.path(name + ".hdf5"), gas);
  std::vector<std::string> words{
      "rates", shop.path(name + ".hdf5"), "--scheme", scheme, "--kernel", "hoct4", "--neighbours", "442", "--out", out};
  if (shop.threads > 0) words.insert(words.end(), {"--threads", std::to_string(shop.threads)});
  if (const int code = run_alone(words, log); code != ExitCode::done)
    throw InputError(fmt::format("exit code {}; see {}", code, log));
  return hdf5::File::open(out);
}

/// The field that differs most between the gas and its copies, over the largest value of the field.
struct Difference {
  double value = 0;
  std::string field = "none";
};

Difference difference(const hdf5::File& thin, const hdf5::File& wide, std::size_t copies) {
  Difference most;
  const hdf5::Group a = thin.group("PartType0"), b = wide.group("PartType0");
  for (const std::string& name : a.members()) {
    if (name == "Coordinates" || name == "ParticleIDs") continue;
    const auto one = a.dataset(name).read<double>(), all = b.dataset(name).read<double>();
    if (all.size() != one.size() * copies) throw InputError(fmt::format("{} has {} values", name, all.size()));
    double scale = 0;
    for (const double value : one) scale = std::max(scale, std::abs(value));
    for (std::size_t k = 0; k < all.size(); ++k) {
      const double off = std::abs(all[k] - one[k % one.size()]) / (scale > 0 ? scale : 1);
      if (!std::isfinite(off)) return {off, name};
      if (off > most.value) most = {off, name};
    }
  }
  return most;
}

}  // namespace

std::vector<Outcome> compare_slabs(const Workshop& shop) {
  struct Slab {
    const char* name;
    Counts counts, copies;
  };
  // Supports of 442 neighbours are 9.5 spacings wide.
  constexpr Slab slabs[] = {{"8 layers", {16, 16, 8}, {1, 1, 2}},
                            {"4 layers", {16, 16, 4}, {1, 1, 3}},
                            {"2 layers", {16, 16, 2}, {1, 1, 6}},
                            {"1 layer", {16, 16, 1}, {1, 1, 12}},
                            {"1000:1:1", {1000, 1, 1}, {1, 12, 12}}};
  std::vector<Outcome> outcomes;
  for (const Slab& slab : slabs) {
    Outcome outcome{fmt::format("{}: rates < {:g} off", slab.name, tolerance), "", true};
    for (const std::string scheme : {"gadget2", "sphs"}) {
      const ParticleSet gas = uneven_gas(slab.counts);
      const hdf5::File thin = rates_of(gas, "thin", scheme, shop),
                       wide = rates_of(laid_out(gas, slab.copies), "wide", scheme, shop);
      const Difference found = difference(thin, wide, slab.copies[0] * slab.copies[1] * slab.copies[2]);
      outcome.found +=
          fmt::format("{}{} {:.1e} ({})", outcome.found.empty() ? "" : ", ", scheme, found.value, found.field);
      outcome.passed = outcome.passed && found.value < tolerance;
    }
    outcomes.push_back(outcome);
  }
  return outcomes;
}

}  // namespace sphk
