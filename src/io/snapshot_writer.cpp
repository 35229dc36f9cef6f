// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/snapshot_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "src/engine/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/hdf5_file.hpp"
#include "src/io/kernel_gamma.hpp"
#include "src/io/readers_box.hpp"
#include "src/io/snapshot_groups.hpp"

namespace sphk {

namespace {

/// GADGET's singular names beside SWIFT's plural ones; SmoothingLength is a dataset of its own.
constexpr std::pair<const char*, const char*> singular_names[] = {
    {"Density", "Densities"}, {"InternalEnergy", "InternalEnergies"}, {"Pressure", "Pressures"}};

std::string power(const char* unit, double exponent) {
  return exponent == 0 ? "" : exponent == 1 ? fmt::format("{} ", unit) : fmt::format("{}^{:g} ", unit, exponent);
}

/// Units and meaning, as SWIFT puts them beside every dataset.
void describe(hdf5::Dataset dataset, const std::string& description, const UnitExponents& exponents,
              const SnapshotInfo& info) {
  const auto [L, M, t] = exponents;
  const auto exponent = [&](const char* name, double value) {
    dataset.set(fmt::format("{} exponent", name), static_cast<float>(value));
  };
  exponent("U_M", M);
  exponent("U_L", L);
  exponent("U_t", t);
  exponent("U_I", 0);
  exponent("U_T", 0);
  exponent("a-scale", 0);
  exponent("h-scale", 0);
  const std::string code = power("U_M", M) + power("U_L", L) + power("U_t", t);
  const std::string cgs = power("g", M) + power("cm", L) + power("s", t);
  dataset.set("Description", description);
  dataset.set("Expression for physical CGS units", fmt::format("{}[ {}]", code, cgs.empty() ? "- " : cgs));
  dataset.set("Lossy compression filter", "None");
  dataset.set("Conversion factor to CGS (not including cosmological corrections)",
              info.units.value_or(Units{}).to_cgs(exponents));
  dataset.set("Value stored as physical", std::int32_t{1});
  dataset.set("Property can be converted to comoving", std::int32_t{0});
}

void write_field(hdf5::Group& gas, const Field& field, const SnapshotInfo& info, bool compressed) {
  const hsize_t columns = field.components == 1 ? 0 : static_cast<hsize_t>(field.components);
  describe(gas.write(field.name, field.values, columns, compressed), field.description, field.units, info);
}

void require_size(const Field& field, std::size_t particles) {
  const std::size_t wanted = particles * static_cast<std::size_t>(field.components);
  if (field.values.size() != wanted)
    throw InputError(fmt::format("the field {} has {} values; {} particles of {} numbers each need {}", field.name,
                                 field.values.size(), particles, field.components, wanted));
}

/// SWIFT's h, in place of the support radius.
Field swift_smoothing_lengths(Field support, const SnapshotInfo& info, int dimension) {
  const double gamma = kernel_gamma(info.kernel, dimension);
  support.name = "SmoothingLengths";
  support.description = "Smoothing length as SWIFT defines it: support radius / kernel gamma";
  for (double& value : support.values) value /= gamma;
  return support;
}

/// Makes the fields' values one after the other, where they are not there yet, and lets go of them.
void write_gas(hdf5::Group gas, Snapshot& snapshot, const SnapshotInfo& info, bool compressed) {
  describe(gas.write("ParticleIDs", snapshot.id, 0, compressed), "Unique number of the particle", {}, info);
  for (Field& field : snapshot.fields) {
    field.fill();
    require_size(field, snapshot.size());
    write_field(gas, field, info, compressed);
    Field gone{field.name, "", field.units, field.components, std::move(field.values)};
    if (field.name == "SmoothingLength")
      write_field(gas, swift_smoothing_lengths(std::move(gone), info, snapshot.dimension), info, compressed);
  }
  for (const auto& [singular, plural] : singular_names)
    if (snapshot.has(plural)) gas.link(singular, fmt::format("/PartType0/{}", plural));
}

/// The same datasets as ParaView wants them: points that are vertices, and the fields as point data. Points are there
/// already, if they are not where the other readers see them.
void write_vtkhdf(hdf5::Group vtk, const Snapshot& snapshot, bool compressed) {
  constexpr std::uint8_t vertex_type = 1;  // VTK_VERTEX
  const auto n = static_cast<std::int64_t>(snapshot.size());
  vtk.set("Version", std::vector<std::int64_t>{1, 0});
  vtk.set("Type", "UnstructuredGrid");
  for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"})
    vtk.write(name, std::vector<std::int64_t>{n});
  std::vector<std::int64_t> counting(snapshot.size() + 1);
  std::iota(counting.begin(), counting.end(), std::int64_t{0});
  vtk.write("Offsets", counting, 0, compressed);
  counting.pop_back();
  vtk.write("Connectivity", counting, 0, compressed);
  vtk.write("Types", std::vector<std::uint8_t>(snapshot.size(), vertex_type), 0, compressed);
  if (!vtk.has("Points")) vtk.link("Points", "/PartType0/Coordinates");
  hdf5::Group point_data = vtk.create_group("PointData");
  point_data.link("ParticleIDs", "/PartType0/ParticleIDs");
  for (const Field& field : snapshot.fields)
    if (field.name != "Coordinates") point_data.link(field.name, fmt::format("/PartType0/{}", field.name));
}

/// Puts the particles where the box has its readers see them.
const std::vector<double>& place_coordinates(Snapshot& snapshot, const ReadersBox& box) {
  std::vector<double>& x = std::ranges::find(snapshot.fields, "Coordinates", &Field::name)->values;
  for (std::size_t i = 0; i < x.size(); i += 3) {
    const Array3 y = box.placed({x[i], x[i + 1], x[i + 2]});
    std::ranges::copy(y, x.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return x;
}

void write_placed(hdf5::File& file, Snapshot snapshot, const SnapshotInfo& info, const ReadersBox& box,
                  Compression compression) {
  const bool compressed = compression == Compression::gzip;
  write_metadata(file, snapshot, info, box);
  hdf5::Group vtk = file.create_group("VTKHDF");
  if (const std::vector<double> points = true_points(snapshot, box); !points.empty())
    vtk.write("Points", points, 3, compressed);
  write_cells(file, place_coordinates(snapshot, box), box);
  write_gas(file.create_group("PartType0"), snapshot, info, compressed);
  write_vtkhdf(std::move(vtk), snapshot, compressed);
}

}  // namespace

void write_snapshot(hdf5::File& file, Snapshot snapshot, const SnapshotInfo& info, Compression compression) {
  require_size(snapshot.field("Coordinates"), snapshot.size());
  const ReadersBox box = readers_box(snapshot);
  write_placed(file, std::move(snapshot), info, box, compression);
}

void write_snapshot(const std::filesystem::path& path, Snapshot snapshot, const SnapshotInfo& info,
                    Compression compression) {
  hdf5::File file = hdf5::File::replacing(path);
  write_snapshot(file, std::move(snapshot), info, compression);
  file.save();
}

void write_fields(const std::filesystem::path& path, const ParticleSet& particles, std::span<const Field> fields,
                  double gamma, const SnapshotInfo& info) {
  Snapshot snapshot;
  snapshot.dimension = particles.dimension;
  snapshot.box = particles.box;
  snapshot.time = particles.time;
  snapshot.gamma = gamma;
  snapshot.id = particles.id;
  if (snapshot.id.empty()) {
    snapshot.id.resize(particles.size());
    std::iota(snapshot.id.begin(), snapshot.id.end(), std::uint64_t{1});
  }
  Field coordinates{"Coordinates", "Position", {1, 0, 0}, 3, {}};
  coordinates.values.reserve(3 * particles.size());
  for (const Array3& x : particles.x) coordinates.values.insert(coordinates.values.end(), x.begin(), x.end());
  snapshot.fields.push_back(std::move(coordinates));
  snapshot.fields.insert(snapshot.fields.end(), fields.begin(), fields.end());
  const ReadersBox box = unshifted_box(snapshot);
  hdf5::File file = hdf5::File::replacing(path);
  write_placed(file, std::move(snapshot), info, box, Compression::none);
  file.save();
}

void write_series(const std::filesystem::path& folder, std::span<const SeriesEntry> entries) {
  std::string files;
  for (const auto& [name, time] : entries)
    files += fmt::format("{}\n    {{\"name\": \"{}\", \"time\": {}}}", files.empty() ? "" : ",", name, time);
  write_atomically(folder / "run.hdf.series",
                   fmt::format("{{\n  \"file-series-version\": \"1.0\",\n  \"files\": [{}\n  ]\n}}\n", files));
}

}  // namespace sphk
