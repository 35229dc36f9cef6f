// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "src/engine/errors.hpp"
#include "src/io/check.hpp"
#include "src/io/hdf5_file.hpp"
#include "src/io/layouts.hpp"
#include "src/io/readers_box.hpp"

namespace sphk {

namespace {

/// A field with more columns than this is named only: without rows it may claim any number of them.
constexpr std::size_t max_columns = 16;

std::string line(const char* name, const std::string& value) {
  return fmt::format("  {:<11} {}\n", name, value);
}

/// Attribute values as text, whatever they hold.
std::string attribute_text(const hdf5::Object& object, const char* name) {
  if (!object.has_attribute(name)) return "unknown";
  try {
    return object.text(name);
  } catch (const InputError&) {
    return fmt::format("{:.8g}", fmt::join(object.numbers(name), " "));
  }
}

/// Their names, and what they are in cgs.
std::string units_line(const hdf5::File& file) {
  std::optional<Units> units;
  try {
    units = facts_of(file).units;
  } catch (const InputError&) {  // which the verdict tells
    return line("units", "unknown");
  }
  if (!units) return line("units", file.has("sphk") ? units_text(units) : "the file does not say");
  return line("units", fmt::format("{} ({:.6g} cm, {:.6g} g, {:.6g} cm/s, {:.6g} s)", units_text(units), units->length,
                                   units->mass, units->velocity(), units->time));
}

std::string own_lines(const hdf5::Group& own) {
  const auto lower = own.numbers("BoxLower"), size = own.numbers("BoxSize"), periodic = own.numbers("Periodic");
  std::vector<std::string> axes;
  for (std::size_t k = 0; k < std::min({lower.size(), size.size(), periodic.size()}); ++k)
    axes.push_back(fmt::format("[{:.8g}, {:.8g}) {}", lower[k], lower[k] + size[k], periodic[k] ? "periodic" : "open"));
  return line("step", attribute_text(own, "Step")) + line("dimension", attribute_text(own, "Dimension")) +
         line("box", fmt::format("{}", fmt::join(axes, " x "))) + line("scene", attribute_text(own, "Scene")) +
         line("scheme", fmt::format("{}, kernel {}, {} neighbours, precision {}", attribute_text(own, "Scheme"),
                                    attribute_text(own, "Kernel"), attribute_text(own, "Neighbours"),
                                    attribute_text(own, "Precision")));
}

std::string foreign_lines(const hdf5::Group& header) {
  std::string text = line("box", header.has_attribute("BoxSize") ? attribute_text(header, "BoxSize") : "none");
  if (header.has_attribute("Dimension")) text += line("dimension", attribute_text(header, "Dimension"));
  return text;
}

/// One line a particle type of the Header's counts.
std::string particle_lines(const hdf5::File& file, const hdf5::Group& header) {
  static constexpr const char* names[] = {"gas", "dark matter", "disc", "bulge", "stars", "black holes", "neutrinos"};
  std::string text;
  const auto counts = header.numbers_or("NumPart_ThisFile", {});
  for (std::size_t type = 0; type < counts.size(); ++type)
    if (counts[type] > 0 || file.has(fmt::format("PartType{}", type)))
      text += line(type < std::size(names) ? names[type] : "other",
                   fmt::format("{:.0f} particles (PartType{})", counts[type], type));
  return text;
}

/// Least, mean and largest of the finite values in one column.
std::string range_text(const std::vector<double>& values, std::size_t column, std::size_t columns) {
  double low = std::numeric_limits<double>::infinity(), high = -low, sum = 0;
  std::size_t finite = 0, bad = 0;
  for (std::size_t i = column; i < values.size(); i += columns) {
    if (!std::isfinite(values[i])) {
      ++bad;
      continue;
    }
    ++finite;
    low = std::min(low, values[i]);
    high = std::max(high, values[i]);
    sum += values[i];
  }
  const std::string not_finite = bad ? fmt::format("  ({} not finite)", bad) : "";
  if (finite == 0) return fmt::format("{:>14}{:>14}{:>14}{}", "-", "-", "-", not_finite);
  return fmt::format("{:>14.6g}{:>14.6g}{:>14.6g}{}", low, sum / static_cast<double>(finite), high, not_finite);
}

/// Those of a run's own coordinates are the run's, not the readers'.
std::vector<double> values_of(const hdf5::File& file, const std::string& name, const hdf5::Dataset& dataset) {
  std::vector<double> values = dataset.read<double>();
  if (name != "Coordinates" || dataset.shape().size() != 2 || dataset.shape()[1] != 3) return values;
  std::vector<Array3> x(values.size() / 3);
  for (std::size_t i = 0; i < values.size(); ++i) x[i / 3][i % 3] = values[i];
  undo_shift(file, x);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = x[i / 3][i % 3];
  return values;
}

std::string field_lines(const hdf5::File& file, const std::string& name, const hdf5::Dataset& dataset) {
  if (!dataset.is_number()) return fmt::format("  {:<28}not numbers\n", name);
  const auto shape = dataset.shape();
  const std::size_t columns = shape.size() == 2 ? shape[1] : 1;
  if (columns > max_columns) return fmt::format("  {:<28}{} columns\n", name, columns);
  const std::vector<double> values = values_of(file, name, dataset);
  std::string text;
  for (std::size_t k = 0; k < columns; ++k) {
    const std::string suffix = columns == 1 ? "" : columns <= 3 ? fmt::format(".{}", "xyz"[k]) : fmt::format("[{}]", k);
    text += fmt::format("  {:<28}{}\n", name + suffix, range_text(values, k, columns));
  }
  return text;
}

std::string gas_table(const hdf5::File& file) {
  const hdf5::Group gas = file.group("PartType0");
  std::string text = fmt::format("  {:<28}{:>14}{:>14}{:>14}\n", "field", "min", "mean", "max");
  std::map<std::uint64_t, std::string> seen;
  for (const std::string& name : gas.members()) {
    const hdf5::Dataset dataset = gas.dataset(name);
    const auto [first, is_new] = seen.emplace(dataset.address(), name);
    text +=
        is_new ? field_lines(file, name, dataset) : fmt::format("  {:<28}  another name of {}\n", name, first->second);
  }
  return text;
}

/// What a run would say when it started from this file.
std::string verdict_lines(const std::filesystem::path& path, const GasRemarks& remarks) {
  std::string text;
  std::vector<std::string> errors;
  try {
    const ReadResult content = read_particles(path, NonFinite::keep);
    Verdict verdict = judge(content);
    if (verdict.errors.empty() && remarks)
      for (std::string& remark : remarks(content.particles)) verdict.notes.push_back(std::move(remark));
    for (const std::string& note : verdict.notes) text += "  note: " + note + "\n";
    errors = verdict.errors;
    if (const std::string doubt = dimension_in_doubt(content); !doubt.empty()) errors.push_back(doubt);
  } catch (const InputError& error) {
    errors.emplace_back(error.what());
  }
  for (const std::string& error : errors) text += fmt::format("  no run can start from it: {}\n", error);
  return text;
}

}  // namespace

std::string file_info(const std::filesystem::path& path, const GasRemarks& remarks) {
  std::string text;
  {
    const hdf5::File file = hdf5::File::open(path);
    const hdf5::Group header = file.group("Header");
    const bool own = file.has("sphk");
    text = fmt::format("{}: {}\n", path.string(),
                       own ? "sphk snapshot" : "HDF5 particles in the layout of SWIFT and GADGET");
    text += line("time", attribute_text(header, "Time"));
    text += units_line(file);
    text += own ? own_lines(file.group("sphk")) : foreign_lines(header);
    if (file.has("HydroScheme")) text += line("gamma", attribute_text(file.group("HydroScheme"), "Adiabatic index"));
    text += particle_lines(file, header);
    if (file.has("PartType0")) text += gas_table(file);
  }
  return text + verdict_lines(path, remarks);
}

}  // namespace sphk
