// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/snapshot_groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <tuple>

#include "src/engine/geometry.hpp"
#include "src/io/kernel_gamma.hpp"

namespace sphk {

namespace {

constexpr int particle_types = 6;

template <class T>
std::vector<T> gas_only(T count) {
  std::vector<T> counts(particle_types, T{0});
  counts[0] = count;
  return counts;
}

/// Least and largest coordinate along an axis; x holds at least one row of three.
std::pair<double, double> extent(const std::vector<double>& x, std::size_t axis) {
  std::pair<double, double> ends{x[axis], x[axis]};
  for (std::size_t i = axis; i < x.size(); i += 3) ends = {std::min(ends.first, x[i]), std::max(ends.second, x[i])};
  return ends;
}

std::vector<double> to_vector(const Array3& a) {
  return {a.begin(), a.end()};
}

std::string now() {
  const std::time_t time = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&time, &parts);
  char text[64];
  std::strftime(text, sizeof(text), "%Y-%m-%d %H:%M:%S UTC", &parts);
  return text;
}

void write_header(hdf5::Group header, const Snapshot& snapshot, const ReadersBox& box, const SnapshotInfo& info) {
  const auto n = static_cast<std::int64_t>(snapshot.size());
  header.set("Code", "SWIFT");  // the layout's tag: yt looks for nothing else
  header.set("Generator", "sphk");
  header.set("RunName", info.scene);
  header.set("SnapshotDate", now());
  header.set("OutputType", "FullVolume");
  header.set("SelectOutput", "Default");
  header.set("BoxSize", to_vector(box.size));
  header.set("Shift", to_vector(box.shift));
  header.set("Time", snapshot.time);
  header.set("Redshift", 0.0);
  header.set("Scale-factor", 1.0);
  header.set("Dimension", std::int32_t{3});  // readers crash on 2; /sphk and HydroScheme have the true one
  header.set("Virtual", std::int32_t{0});
  header.set("ThisFile", std::int32_t{0});
  header.set("NumFilesPerSnapshot", std::int32_t{1});
  header.set("NumPart_ThisFile", gas_only<std::int64_t>(n));
  header.set("TotalNumberOfParticles", gas_only<std::int64_t>(n));
  header.set("NumPart_Total", gas_only<std::uint32_t>(static_cast<std::uint32_t>(n)));
  header.set("NumPart_Total_HighWord", gas_only<std::uint32_t>(static_cast<std::uint32_t>(n >> 32)));
  header.set("MassTable", gas_only<double>(0));
  header.set("InitialMassTable", gas_only<double>(0));
  header.set("Flag_Entropy_ICs", gas_only<std::uint32_t>(0));
  header.set("CanHaveTypes", gas_only<std::int32_t>(1));
}

/// Code units count as cgs: readers then show the numbers of the run.
void write_units(hdf5::Group group, const Units& units) {
  group.set("Unit mass in cgs (U_M)", units.mass);
  group.set("Unit length in cgs (U_L)", units.length);
  group.set("Unit time in cgs (U_t)", units.time);
  group.set("Unit current in cgs (U_I)", 1.0);
  group.set("Unit temperature in cgs (U_T)", 1.0);
}

void write_parameters(hdf5::Group parameters, bool periodic, const Settings& settings) {
  parameters.set("InitialConditions:periodic", periodic ? "1" : "0");
  for (const Key& key : settings.keys()) {
    std::string name = key.name;
    std::replace(name.begin(), name.end(), '.', ':');
    const auto* text = std::get_if<std::string>(&key.value);
    parameters.set(name, text ? *text : to_text(key.value));
  }
}

void write_hydro_scheme(hdf5::Group hydro, const Snapshot& snapshot, const SnapshotInfo& info) {
  const double gamma = kernel_gamma(info.kernel, snapshot.dimension);
  hydro.set("Scheme", info.scheme);
  hydro.set("Kernel function", info.kernel);
  hydro.set("Dimension", std::int32_t{snapshot.dimension});
  hydro.set("Adiabatic index", snapshot.gamma);
  hydro.set("Kernel gamma", gamma);
  // S12 eq 11, N = V_D (H/dx)^D with H = gamma eta dx, solved for SWIFT's eta.
  hydro.set("Kernel eta",
            std::pow(info.neighbours / unit_sphere_volume(snapshot.dimension), 1.0 / snapshot.dimension) / gamma);
  hydro.set("Kernel target N_ngb", info.neighbours);
  hydro.set("CFL parameter", info.courant);
}

void write_code(hdf5::Group code, const SnapshotInfo& info) {
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  code.set("Code", "sphk");
  code.set("Code Version", info.version);
  code.set("Git Revision", info.git_revision);
#ifdef __clang__
  code.set("Compiler Name", "Clang");
#else
  code.set("Compiler Name", "GCC");
#endif
  code.set("Compiler Version", __VERSION__);
  code.set("HDF5 library version", fmt::format("{}.{}.{}", major, minor, release));
  code.set("Kokkos backend", info.backend);
}

void write_own_group(hdf5::Group own, const Snapshot& snapshot, const SnapshotInfo& info) {
  const auto& periodic = snapshot.box.periodic;
  own.set("SchemaVersion", std::int32_t{snapshot_schema});
  own.set("Dimension", std::int32_t{snapshot.dimension});
  own.set("Step", std::int64_t{snapshot.step});
  own.set("BoxLower", to_vector(snapshot.box.lower));
  own.set("BoxSize", to_vector(snapshot.box.size));
  own.set("Periodic", std::vector<std::int32_t>(periodic.begin(), periodic.end()));
  own.set("CodeUnits", std::int32_t{!info.units});
  own.set("Scene", info.scene);
  own.set("Scheme", info.scheme);
  own.set("Kernel", info.kernel);
  own.set("Precision", info.precision);
  own.set("Neighbours", info.neighbours);
  own.set("SceneText", info.scene_text);
}

}  // namespace

void write_metadata(hdf5::File& file, const Snapshot& snapshot, const SnapshotInfo& info, const ReadersBox& box) {
  write_header(file.create_group("Header"), snapshot, box, info);
  for (const char* group : {"Units", "InternalCodeUnits"})
    write_units(file.create_group(group), info.units.value_or(Units{}));
  file.create_group("Policy").set("cosmological integration", std::int32_t{0});
  file.create_group("RuntimePars").set("PeriodicBoundariesOn", std::int32_t{box.periodic});
  file.create_group("Cosmology").set("Cosmological run", std::int32_t{0});
  file.create_group("SubgridScheme");
  write_parameters(file.create_group("Parameters"), box.periodic, info.settings);
  write_hydro_scheme(file.create_group("HydroScheme"), snapshot, info);
  write_code(file.create_group("Code"), info);
  write_own_group(file.create_group("sphk"), snapshot, info);
}

void write_cells(hdf5::File& file, const std::vector<double>& coordinates, const ReadersBox& box) {
  std::vector<double> centre(3), lowest(3), highest(3);
  for (std::size_t k = 0; k < 3; ++k) {
    centre[k] = 0.5 * box.size[k];
    highest[k] = box.size[k];
    if (!coordinates.empty()) std::tie(lowest[k], highest[k]) = extent(coordinates, k);
  }
  hdf5::Group cells = file.create_group("Cells");
  hdf5::Group meta = cells.create_group("Meta-data");
  meta.set("dimension", std::vector<std::int32_t>(3, 1));
  meta.set("nr_cells", std::int32_t{1});
  meta.set("size", to_vector(box.size));
  cells.write("Centres", centre, 3);
  const std::vector<std::int64_t> count{static_cast<std::int64_t>(coordinates.size() / 3)}, zero{0};
  cells.create_group("Counts").write("PartType0", count);
  cells.create_group("OffsetsInFile").write("PartType0", zero);
  cells.create_group("Files").write("PartType0", zero);
  cells.create_group("MinPositions").write("PartType0", lowest, 3);
  cells.create_group("MaxPositions").write("PartType0", highest, 3);
}

}  // namespace sphk
