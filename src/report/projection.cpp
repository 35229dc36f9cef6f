// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/projection.hpp"

#include <Kokkos_Core.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sphk {

namespace {

using Host = Kokkos::DefaultHostExecutionSpace;

constexpr int band_rows = 16;  // of pixels, that one thread fills

/// A particle, or an image of one, on the picture, whose lower corner is the origin: `share` (1 - s^2)^3 out to the
/// radius.
struct Splat {
  double x, y, radius, share, value;
};

/// The pixels whose centres lie within `reach` of a place: [first, last), which may lie outside the picture.
struct Interval {
  int first, last;
  Interval(double place, double reach, double pixel)
      : first(static_cast<int>(std::ceil((place - reach) / pixel - 0.5))),
        last(static_cast<int>(std::floor((place + reach) / pixel - 0.5)) + 1) {}

  Interval within(int low, int high) const {
    Interval part = *this;
    part.first = std::clamp(first, low, high);
    part.last = std::clamp(last, low, high);
    return part;
  }
};

/// Sum over equidistant s_i of (row - s_i^2)^3: by Euler and Maclaurin the difference of this function half a step
/// behind the last s_i and half a step before the first, over the step, exactly, since the polynomial ends.
double summed(double s, double step, double row) {
  const double s2 = s * s, d2 = step * step;
  const double integral = row * row * row - s2 * (row * row - s2 * (0.6 * row - s2 / 7));
  const double first = -6 * (row - s2) * (row - s2), third = 72 * row - 120 * s2, fifth = -720;
  return s * (integral - d2 * (first / 24 - d2 * (7 * third / 5760 - d2 * 31 * fifth / 967680)));
}

/// Draws splats on a grid of pixels.
class Canvas {
 public:
  explicit Canvas(const PictureFrame& frame)
      : pixels_(frame.pixels),
        pixel_{frame.size[0] / frame.pixels[0], frame.size[1] / frame.pixels[1]},
        means_(frame.z || frame.dimension == 2) {
    const std::size_t size = static_cast<std::size_t>(pixels_[0]) * static_cast<std::size_t>(pixels_[1]);
    map_.values.resize(size);
    if (means_) map_.cover.resize(size);
  }

  double least_radius() const { return least_map_radius * std::max(pixel_[0], pixel_[1]); }
  int bands() const { return (pixels_[1] + band_rows - 1) / band_rows; }

  /// What a splat's kernel is to be multiplied with for all its pixels, of the picture and outside, to add up to its
  /// share.
  double scale(const Splat& splat) const {
    const double d = step(splat), start = -splat.x / splat.radius;
    double sum = 0;
    each_row(splat, rows(splat), [&](int, double row, const Interval& columns) {
      sum += summed(start + columns.last * d, d, row) - summed(start + columns.first * d, d, row);
    });
    return splat.share * d / (pixel_[0] * pixel_[1] * sum);
  }

  /// Adds all splats, in their order, to the rows of a band.
  void draw(const std::vector<Splat>& splats, int band) {
    const int first = band * band_rows, last = std::min(first + band_rows, pixels_[1]);
    for (const Splat& splat : splats)
      each_row(splat, rows(splat).within(first, last), [&](int j, double row, const Interval& columns) {
        const std::size_t start = static_cast<std::size_t>(j) * static_cast<std::size_t>(pixels_[0]);
        const Interval seen = columns.within(0, pixels_[0]);
        add(splat, row, seen, splat.share * splat.value, map_.values.data() + start);
        if (means_) add(splat, row, seen, splat.share, map_.cover.data() + start);
      });
  }

  FieldMap finished() {
    for (std::size_t k = 0; means_ && k < map_.values.size(); ++k)
      map_.values[k] = map_.cover[k] > 0 ? map_.values[k] / map_.cover[k] : std::numeric_limits<double>::quiet_NaN();
    return std::move(map_);
  }

 private:
  double step(const Splat& splat) const { return pixel_[0] / splat.radius; }
  Interval rows(const Splat& splat) const { return {splat.y, splat.radius, pixel_[1]}; }

  /// Calls act(j, 1 - (y_j / radius)^2, the pixels in reach) for rows of a splat.
  template <class Act>
  void each_row(const Splat& splat, const Interval& rows, Act act) const {
    const double d = pixel_[1] / splat.radius, start = 0.5 * d - splat.y / splat.radius;
    for (int j = rows.first; j < rows.last; ++j) {
      const double s = start + j * d;
      if (const double row = 1 - s * s; row > 0) act(j, row, {splat.x, splat.radius * std::sqrt(row), pixel_[0]});
    }
  }

  void add(const Splat& splat, double row, const Interval& columns, double factor, double* to) const {
    const double d = step(splat), start = 0.5 * d - splat.x / splat.radius;
    for (int i = columns.first; i < columns.last; ++i) {
      const double s = start + i * d, t = row - s * s;
      to[i] += factor * t * t * t;
    }
  }

  std::array<int, 2> pixels_;
  std::array<double, 2> pixel_;
  bool means_;
  FieldMap map_;
};

/// Shifts by which a periodic axis brings images within `reach` of [low, high]; that of an open one is 0.
std::vector<double> shifts(bool periodic, double period, double place, double reach, double low, double high) {
  if (!periodic) return {0.0};
  std::vector<double> all;
  const double last = std::floor((high + reach - place) / period);
  for (double k = std::ceil((low - reach - place) / period); k <= last; ++k) all.push_back(k * period);
  return all;
}

/// The images that a picture sees of what lies at (x, y).
void add_images(std::vector<Splat>& splats, const PictureFrame& frame, const Splat& of) {
  const auto along = [&](std::size_t axis, double place) {
    return shifts(frame.box.periodic[axis], frame.box.size[axis], place, of.radius, frame.lower[axis],
                  frame.lower[axis] + frame.size[axis]);
  };
  for (const double right : along(0, of.x))
    for (const double up : along(1, of.y)) {
      Splat splat = of;
      splat.x += right - frame.lower[0];
      splat.y += up - frame.lower[1];
      const bool seen = splat.x > -of.radius && splat.x < frame.size[0] + of.radius && splat.y > -of.radius &&
                        splat.y < frame.size[1] + of.radius;
      if (seen) splats.push_back(splat);
    }
}

/// All that the picture sees; `share` is the volume, or of a slice the area in it.
std::vector<Splat> splats_of(const ProjectedGas& gas, const PictureFrame& frame, double least_radius) {
  constexpr double height = 315.0 / 256;  // over the integral of (1 - q^2)^4 from -1 to 1
  std::vector<Splat> splats;
  for (std::size_t i = 0; i < gas.volume.size(); ++i) {
    const double *const x = &gas.x[3 * i], volume = gas.volume[i], value = gas.value[i];
    if (!std::isfinite(x[0] + x[1] + x[2] + volume + value) || !(volume > 0)) continue;
    const double spacing = frame.dimension == 2 ? std::sqrt(volume) : std::cbrt(volume);
    const double radius = std::max(map_radius * spacing, least_radius);
    if (!frame.z || frame.dimension == 2) {
      add_images(splats, frame, {x[0], x[1], radius, volume, value});
      continue;
    }
    for (const double up : shifts(frame.box.periodic[2], frame.box.size[2], x[2], radius, *frame.z, *frame.z)) {
      const double zeta = (x[2] + up - *frame.z) / radius, flat = 1 - zeta * zeta;
      if (flat > 0)
        add_images(splats, frame,
                   {x[0], x[1], std::max(radius * std::sqrt(flat), least_radius),
                    volume * height / radius * std::pow(flat, 4), value});
    }
  }
  return splats;
}

}  // namespace

FieldMap project(const ProjectedGas& gas, const PictureFrame& frame) {
  Canvas canvas(frame);
  std::vector<Splat> splats = splats_of(gas, frame, canvas.least_radius());
  Kokkos::parallel_for("map_scales", Kokkos::RangePolicy<Host>(0, static_cast<int>(splats.size())), [&](int k) {
    splats[static_cast<std::size_t>(k)].share = canvas.scale(splats[static_cast<std::size_t>(k)]);
  });
  Kokkos::parallel_for("map", Kokkos::RangePolicy<Host>(0, canvas.bands()),
                       [&](int band) { canvas.draw(splats, band); });
  return canvas.finished();
}

}  // namespace sphk
