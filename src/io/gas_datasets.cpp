// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/gas_datasets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>

#include "src/engine/errors.hpp"

namespace sphk {

namespace {

/// Accepted names of one dataset: SWIFT's first, then GADGET's and GIZMO's.
using Names = std::initializer_list<const char*>;

std::optional<hdf5::Dataset> find(const hdf5::Group& gas, Names names) {
  for (const char* name : names)
    if (gas.has(name)) return gas.dataset(name);
  return std::nullopt;
}

hdf5::Dataset require(const hdf5::Group& gas, Names names) {
  if (auto dataset = find(gas, names)) return std::move(*dataset);
  throw InputError(fmt::format("{}: there is no dataset named {}; it has {}", gas.where(), fmt::join(names, " or "),
                               fmt::join(gas.members(), ", ")));
}

/// sphk knows no composition, without which a temperature is no energy.
hdf5::Dataset require_energies(const hdf5::Group& gas) {
  const Names names = {"InternalEnergies", "InternalEnergy"};
  if (!find(gas, names) && find(gas, {"Temperatures", "Temperature"}))
    throw InputError(gas.where() +
                     ": there are temperatures, but no InternalEnergies; write the specific thermal energies k T / "
                     "((gamma - 1) mu m_H), in the file's units");
  return require(gas, names);
}

[[noreturn]] void wrong_shape(const hdf5::Dataset& dataset, const std::string& wanted) {
  throw InputError(fmt::format("{}: its shape is ({}), but {} is wanted", dataset.where(),
                               fmt::join(dataset.shape(), ", "), wanted));
}

void require_finite(const hdf5::Dataset& dataset, const std::vector<double>& values, std::size_t columns) {
  const auto bad = [](double value) { return !std::isfinite(value); };
  const auto first = std::find_if(values.begin(), values.end(), bad);
  if (first == values.end()) return;
  throw InputError(
      fmt::format("{}: row {} (from 0) is {}, the first of {} values that are not finite; mend the file. "
                  "`sphk ic check FILE` lists everything that is wrong in it",
                  dataset.where(), static_cast<std::size_t>(first - values.begin()) / columns, *first,
                  std::count_if(first, values.end(), bad)));
}

/// Components per row: (n) and (n,1) have one.
std::size_t columns_of(const hdf5::Dataset& dataset, std::size_t most) {
  const auto shape = dataset.shape();
  const std::size_t columns = shape.size() == 2 ? shape[1] : 1;
  if (shape.empty() || shape.size() > 2 || columns < 1 || columns > most)
    wrong_shape(dataset, most == 1 ? "(n) or (n, 1)" : "(n, 3), (n, 2), (n, 1) or (n)");
  return columns;
}

void require_rows(const hdf5::Dataset& dataset, std::size_t rows) {
  if (dataset.shape()[0] != rows)
    wrong_shape(dataset, fmt::format("one row for each of the {} rows of Coordinates", rows));
}

/// All numbers, of rows of up to `most`; any number of rows where `rows` is empty.
std::vector<double> read_values(const hdf5::Dataset& dataset, std::size_t most, std::optional<std::size_t> rows,
                                NonFinite non_finite) {
  const std::size_t columns = columns_of(dataset, most);
  if (rows) require_rows(dataset, *rows);
  std::vector<double> values = dataset.read<double>();
  if (non_finite == NonFinite::refuse) require_finite(dataset, values, columns);
  return values;
}

/// Rows of one to three numbers, padded with zeros.
std::vector<Array3> read_vectors(const hdf5::Dataset& dataset, std::optional<std::size_t> rows, NonFinite non_finite) {
  const std::size_t columns = columns_of(dataset, 3);
  const std::vector<double> values = read_values(dataset, 3, rows, non_finite);
  std::vector<Array3> vectors(values.size() / columns);
  for (std::size_t i = 0; i < values.size(); ++i) vectors[i / columns][i % columns] = values[i];
  return vectors;
}

std::vector<std::uint64_t> read_ids(const hdf5::Dataset& dataset, std::size_t rows) {
  columns_of(dataset, 1);
  require_rows(dataset, rows);
  if (!dataset.is_integer())
    throw InputError(dataset.where() + ": ids must be integers; write them as 64-bit integers");
  if (!dataset.is_signed()) return dataset.read<std::uint64_t>();
  const auto values = dataset.read<std::int64_t>();  // HDF5 would turn negative numbers into 0 without a word
  const auto negative = std::find_if(values.begin(), values.end(), [](std::int64_t id) { return id < 0; });
  if (negative != values.end())
    throw InputError(fmt::format("{}: row {} (from 0) is {}; ids must not be negative: renumber the particles",
                                 dataset.where(), negative - values.begin(), *negative));
  return {values.begin(), values.end()};
}

/// Before anything is read: so many would not fit into memory either.
void require_countable(const hdf5::Dataset& coordinates, std::size_t before) {
  const double rows = static_cast<double>(coordinates.shape()[0]) + static_cast<double>(before);
  if (rows > static_cast<double>(most_particles))
    throw InputError(fmt::format("{}: {:.0f} gas particles are more than sphk can count, {}; take fewer",
                                 coordinates.where(), rows, most_particles));
}

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

void add_gas(ParticleSet& gas, const hdf5::Group& group, double table_mass, NonFinite non_finite) {
  const hdf5::Dataset coordinates = require(group, {"Coordinates"});
  gas.dimension = static_cast<int>(columns_of(coordinates, 3));
  require_countable(coordinates, gas.size());
  const std::vector<Array3> x = read_vectors(coordinates, std::nullopt, non_finite);
  const auto scalars = [&](const hdf5::Dataset& dataset) { return read_values(dataset, 1, x.size(), non_finite); };
  append(gas.x, x);
  append(gas.v, read_vectors(require(group, {"Velocities", "Velocity"}), x.size(), non_finite));
  append(gas.u, scalars(require_energies(group)));
  if (!find(group, {"Masses", "Mass"}) && table_mass > 0)
    gas.m.resize(gas.x.size(), table_mass);
  else
    append(gas.m, scalars(require(group, {"Masses", "Mass"})));
  if (const auto h = find(group, {"SmoothingLength", "SmoothingLengths"})) append(gas.h, scalars(*h));
  if (const auto alpha = find(group, {"Alpha"})) append(gas.alpha, scalars(*alpha));
  if (const auto ids = find(group, {"ParticleIDs", "ParticleID"})) append(gas.id, read_ids(*ids, x.size()));
}

}  // namespace sphk
