// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "src/run/plot_items.hpp"

namespace sphk {

/// A field that a figure shows, and on which scale.
struct FieldView {
  std::string field;          ///< empty: the density
  std::vector<double> range;  ///< its lowest and highest value; empty: those that there are
  bool logarithmic = false;
  MapView map;

  const std::string& name() const;
  /// Throws InputError where the wishes contradict each other.
  void check() const;
  /// As the drawing scripts take it.
  nlohmann::ordered_json json() const;
};

/// The snapshots to draw and the folder of their run.
struct PlotTargets {
  std::filesystem::path what, folder;  ///< as the user says; of the run
  std::vector<std::filesystem::path> snapshots;
  bool whole_run = false;

  std::filesystem::path history() const { return folder / "history.csv"; }
  /// Throws InputError where it is no file.
  bool has_history() const;
  /// The problem of the run, where the folder tells it.
  std::optional<Problem> problem() const;
};

/// Of a run's folder the last snapshot, or every one of them; or a snapshot. Throws InputError.
PlotTargets find_targets(const std::filesystem::path& what, bool every);

/// Throws InputError unless the snapshot has the field, and positive values of it where the scale is logarithmic and
/// the range does not say what of it is shown.
void check_field(const FieldView& view, const PlotItem& item);

/// Throws InputError where no map can be made of a snapshot.
void check_map(const FieldView& view, const PlotItem& item);

/// Throws InputError where work orders, whose pictures have one scale, are in different units.
void require_same_units(const nlohmann::ordered_json& items);

}  // namespace sphk
