// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "src/io/reader.hpp"
#include "src/report/number_files.hpp"
#include "src/run/plot_fields.hpp"
#include "src/run/problem.hpp"

namespace sphk {

/// What maps show of the gas.
struct MapView {
  std::vector<double> window{};   ///< x0, x1, y0, y1; empty: the box along periodic axes, the gas along open ones
  std::optional<double> slice{};  ///< the height z of the plane in 3D; nothing: the middle of the box
  bool column = false;            ///< the integral along z in place of a plane
  int pixels = 512;               ///< along the longer side
};

/// A snapshot as the drawing scripts take it: where the particles are, what to draw around them, and arrays of it in
/// files. Without the problem it is drawn plainly.
class PlotItem {
 public:
  /// `files` must outlive the scripts that draw. Throws InputError.
  PlotItem(const std::filesystem::path& snapshot, const std::optional<Problem>& problem, NumberFiles& files);

  int dimension() const { return content_.particles.dimension; }
  bool has(const std::string& field) const { return fields_.contains(field); }
  /// Throws InputError with the names that there are where `field` is none of them.
  std::vector<double> values(const std::string& field) const;
  /// Does a slice show more than the profile? Always in 2D; in 3D around a centre and where the scene says so.
  bool suits_map() const;
  bool prefers_map() const { return hint_.map; }  ///< the scene
  /// What the scene shows along its coordinate, and what else is known of the scheme, of what there is.
  std::vector<std::string> own_fields() const;
  bool fills_box() const { return box().periodic[0] && box().periodic[1]; }  ///< along x and y
  /// x0, x1, y0, y1 of a map that shows all.
  std::array<double, 4> extent() const;

  /// The exact solution, where there is one.
  void add_exact(const Problem& problem);
  /// Fields along the scene's coordinate.
  void add_along(const std::vector<std::string>& fields);
  /// Numbers of the particles by field; "x": their positions.
  void add_numbers(const std::string& field);
  /// A map; needs masses, densities and more than one dimension.
  void add_map(const std::string& field, const MapView& view);

  nlohmann::ordered_json json;

 private:
  const Box& box() const { return content_.particles.box; }
  const PlotField& field(const std::string& name) const;
  std::vector<double> abscissa() const;

  std::filesystem::path snapshot_;
  ReadResult content_;
  PlotHint hint_;
  Array3 centre_;
  std::map<std::string, PlotField> fields_;
  NumberFiles& files_;
};

}  // namespace sphk
