// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/plot_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "kernels/core/error_fields.hpp"
#include "src/engine/errors.hpp"
#include "src/io/hdf5_file.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

/// A short name and the datasets that it may stand for, in the order of preference: plural names are SWIFT's and ours,
/// singular ones GADGET's.
struct ShortName {
  const char* name;
  std::array<const char*, 2> datasets;
};
constexpr std::array short_names{ShortName{"rho", {Density::facts.name, "Density"}},
                                 ShortName{"v", {Velocity::facts.name, ""}},
                                 ShortName{"P", {Pressure::facts.name, "Pressure"}},
                                 ShortName{"u", {"InternalEnergies", "InternalEnergy"}},
                                 ShortName{"A", {Entropy::facts.name, ""}},
                                 ShortName{"m", {Mass::facts.name, ""}},
                                 ShortName{"h", {Support::facts.name, ""}},
                                 ShortName{"alpha", {alpha_dataset, ""}},
                                 ShortName{"div_v", {VelocityDivergence::facts.name, ""}},
                                 ShortName{"E0", {ErrorE0::facts.name, ""}}};

const std::vector<std::string> matrix_parts{"xx", "yy", "zz", "xy", "xz", "yz"};

/// The names of the parts of a dataset of so many columns: those that gas of this dimension has.
std::vector<std::string> parts_of(std::size_t columns, int dimension) {
  std::vector<std::string> parts;
  if (columns == 3) {
    parts = {"x", "y", "z"};
    parts.resize(static_cast<std::size_t>(dimension));
    if (dimension > 1) parts.insert(parts.end(), {"R", "phi", "r"});
  } else if (columns == matrix_parts.size()) {
    std::ranges::copy_if(matrix_parts, std::back_inserter(parts), [&](const std::string& part) {
      return std::ranges::all_of(part, [&](char axis) { return axis - 'x' < dimension; });
    });
  }
  return parts;
}

hdf5::Group gas_of(const fs::path& snapshot) {
  return hdf5::File::open(snapshot).group("PartType0");
}

/// The field that a dataset is under a name, and those of its parts.
void add(std::vector<PlotField>& fields, const std::string& name, const hdf5::Dataset& dataset,
         const std::string& dataset_name, int dimension) {
  const auto shape = dataset.shape();
  const std::size_t columns = shape.size() == 2 ? shape[1] : 1;
  if (!dataset.is_number() || shape.empty() || shape.size() > 2) return;
  const auto parts = parts_of(columns, dimension);
  if (columns == 1) fields.push_back({name, dataset_name, ""});
  if (columns == 3) {
    fields.push_back({name, dataset_name, "modulus"});
    fields.push_back({"|" + name + "|", dataset_name, "modulus"});
  }
  for (const std::string& part : parts) fields.push_back({name + "_" + part, dataset_name, part});
}

/// A vector's component along R, phi or r, where a particle is d from the centre.
double about_centre(const std::string& part, const Array3& d, const double* vector, const Array3& velocity) {
  const Array3 v{vector[0] - velocity[0], vector[1] - velocity[1], vector[2] - velocity[2]};
  if (part == "r") {
    const double r = std::hypot(d[0], d[1], d[2]);
    return r > 0 ? (d[0] * v[0] + d[1] * v[1] + d[2] * v[2]) / r : 0;
  }
  const double R = std::hypot(d[0], d[1]);
  if (R == 0) return 0;
  return part == "R" ? (d[0] * v[0] + d[1] * v[1]) / R : (d[0] * v[1] - d[1] * v[0]) / R;
}

}  // namespace

std::vector<PlotField> plot_fields(const fs::path& snapshot, int dimension) {
  const hdf5::Group gas = gas_of(snapshot);
  std::vector<PlotField> fields;
  for (const auto& [name, datasets] : short_names)
    for (const std::string dataset : datasets)
      if (!dataset.empty() && gas.has(dataset)) {
        add(fields, name, gas.dataset(dataset), dataset, dimension);
        break;
      }
  for (const std::string& dataset : gas.members())
    if (std::ranges::find(fields, dataset, &PlotField::name) == fields.end())
      add(fields, dataset, gas.dataset(dataset), dataset, dimension);
  return fields;
}

void refuse_plot_field(const std::vector<PlotField>& fields, const std::string& name, const fs::path& snapshot) {
  std::vector<std::string> names;
  std::set<std::pair<std::string, std::string>> told;
  for (const PlotField& field : fields)
    if (told.emplace(field.dataset, field.part).second) names.push_back(field.name);
  throw InputError(
      fmt::format("{} has no field \"{}\" to draw; it has {}", snapshot.string(), name, fmt::join(names, ", ")));
}

Array3 offset(const Array3& x, const Array3& centre, const ParticleSet& gas) {
  Array3 d{};
  for (std::size_t k = 0; k < static_cast<std::size_t>(gas.dimension); ++k) {
    d[k] = x[k] - centre[k];
    if (gas.box.periodic[k]) d[k] -= gas.box.size[k] * std::round(d[k] / gas.box.size[k]);
  }
  return d;
}

std::vector<double> field_values(const PlotField& field, const fs::path& snapshot, const ParticleSet& gas,
                                 const PlotCentre& centre) {
  const hdf5::Dataset dataset = gas_of(snapshot).dataset(field.dataset);
  std::vector<double> values = dataset.read<double>();
  const auto shape = dataset.shape();
  const std::size_t columns = shape.size() == 2 ? shape[1] : 1;
  if (columns == 1) return values;
  const bool beside = field.dataset == Velocity::facts.name;
  const auto one = columns == 3
                       ? std::string("xyz").find(field.part)
                       : static_cast<std::size_t>(std::ranges::find(matrix_parts, field.part) - matrix_parts.begin());
  std::vector<double> part(shape[0]);
  for (std::size_t i = 0; i < part.size(); ++i) {
    const double* const row = &values[columns * i];
    if (field.part == "modulus")
      part[i] = std::hypot(row[0], row[1], row[2]);
    else if (one < columns)
      part[i] = row[one];
    else
      part[i] = about_centre(field.part, offset(gas.x[i], centre.place, gas), row, beside ? centre.velocity : Array3{});
  }
  return part;
}

}  // namespace sphk
