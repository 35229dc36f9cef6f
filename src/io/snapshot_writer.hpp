// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "src/engine/particle_set.hpp"
#include "src/engine/settings.hpp"
#include "src/io/units.hpp"

namespace sphk {

/// What a snapshot tells about the run it belongs to.
struct SnapshotInfo {
  std::string scene;
  std::string scheme = "sph";
  std::string kernel = "cs";
  std::string precision = "mixed";
  std::string backend;       ///< Kokkos execution space, such as "OpenMP"
  std::string version;       ///< of sphk
  std::string git_revision;  ///< of sphk
  std::string scene_text;    ///< the complete scene file (TOML)
  double neighbours = 48;    ///< N_n of S12 eq 11
  double courant = 0.4;
  std::optional<Units> units;  ///< empty: code units, which readers are told are cgs
  Settings settings;           ///< every key is echoed under /Parameters
};

enum class Compression { none, gzip };

/// Writes `snapshot` as one HDF5 file that yt, pynbody, swiftsimio, SPLASH and ParaView open: SWIFT's layout, GADGET's
/// singular names and a /VTKHDF group as hard links. All numbers are in the units of `info`. Coordinates are moved to
/// where readers look for them (readers_box.hpp), which read_particles undoes.
/// Fields of a view (Simulation::view) are made one after the other. The file appears under its name only when it is
/// complete and on the disk. Throws InputError when the folder cannot be written, the disk is
/// full, or a field does not have `snapshot.size()` rows.
void write_snapshot(const std::filesystem::path& path, Snapshot snapshot, const SnapshotInfo& info,
                    Compression compression = Compression::none);

/// Writes `fields`, whose rows are in the order of `particles`, beside their ids and coordinates, which are not moved,
/// in a file laid out like a snapshot: the output of `sphk rates`. `gamma` is the adiabatic index. Errors as for
/// write_snapshot.
void write_fields(const std::filesystem::path& path, const ParticleSet& particles, std::span<const Field> fields,
                  double gamma, const SnapshotInfo& info);

/// One snapshot of a run: its file name within the folder, free of quotes and backslashes, and its time.
struct SeriesEntry {
  std::string name;
  double time = 0;
};

/// Writes `folder`/run.hdf.series, the text by which ParaView opens all snapshots of a run.
void write_series(const std::filesystem::path& folder, std::span<const SeriesEntry> entries);

}  // namespace sphk
