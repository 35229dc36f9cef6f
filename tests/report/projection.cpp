// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/projection.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace sphk {
namespace {

/// Gas with its own arrays.
struct Gas {
  std::vector<double> x, volume, value;

  ProjectedGas view() const { return {x, volume, value}; }
  void add(const Array3& place, double v, double f) {
    x.insert(x.end(), place.begin(), place.end());
    volume.push_back(v);
    value.push_back(f);
  }
};

/// n particles along each axis of the unit box, with the value f(x).
template <class F>
Gas lattice(int dimension, int n, F f) {
  Gas gas;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < (dimension == 3 ? n : 1); ++k) {
        const Array3 x{(i + 0.5) / n, (j + 0.5) / n, dimension == 3 ? (k + 0.5) / n : 0};
        gas.add(x, std::pow(n, -dimension), f(x));
      }
  return gas;
}

PictureFrame unit_frame(int dimension, bool periodic, int pixels) {
  PictureFrame frame{.dimension = dimension, .box = {}, .lower = {0, 0}, .size = {1, 1}, .pixels = {pixels, pixels}};
  frame.box.periodic = {periodic, periodic, periodic && dimension == 3};
  return frame;
}

/// The integral over the picture.
double integral(const PictureFrame& frame, const std::vector<double>& map) {
  long double sum = 0;
  for (const double value : map) sum += value;
  return static_cast<double>(sum) * frame.size[0] / frame.pixels[0] * frame.size[1] / frame.pixels[1];
}

constexpr double rounding = 1e-12;

TEST(Projection, TheMassOfAColumnMapIsThatOfTheGas) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  Gas gas;
  double mass = 0;
  for (int i = 0; i < 300; ++i) {  // from a thousandth of a pixel to more than the box
    const double volume = std::pow(10.0, -15 + 15 * uniform(random)), rho = 1 + uniform(random);
    gas.add({uniform(random), uniform(random), uniform(random)}, volume, rho);
    mass += rho * volume;
  }
  const PictureFrame frame = unit_frame(3, true, 32);
  EXPECT_NEAR(integral(frame, project(gas.view(), frame).values), mass, rounding * mass);
}

TEST(Projection, AUniformLatticeIsConstant) {
  for (const int dimension : {2, 3}) {
    const Gas gas = lattice(dimension, 12, [](const Array3&) { return 3.0; });
    PictureFrame frame = unit_frame(dimension, true, 40);
    if (dimension == 3) frame.z = 0.3;
    const FieldMap map = project(gas.view(), frame);
    for (const double value : map.values) EXPECT_NEAR(value, 3, 3 * rounding);
    // (1 - q^2)^3 on a square lattice of spacing R / 2.5 sums up to 1 within 4 * 384 J4(k)/k^4, k = 5 pi.
    for (const double cover : map.cover) EXPECT_NEAR(cover, 1, 0.007);
  }
}

TEST(Projection, AMeanOfALinearFieldIsLinearInside) {
  const auto field = [](const Array3& x) { return 1 + 2 * x[0] - x[1]; };
  const Gas gas = lattice(2, 20, field);
  const PictureFrame frame = unit_frame(2, false, 60);  // centres of pixels lie on symmetry lines of the lattice
  const FieldMap map = project(gas.view(), frame);
  for (int j = 10; j < 50; ++j)
    for (int i = 10; i < 50; ++i) {
      const Array3 x{(i + 0.5) / 60, (j + 0.5) / 60, 0};
      // Where the pixel's centre is none of a lattice cell the mean is off by a part of a spacing, 0.05.
      EXPECT_NEAR(map.values[static_cast<std::size_t>(60 * j + i)], field(x), i % 3 == 1 && j % 3 == 1 ? 1e-11 : 3e-3);
    }
}

TEST(Projection, OneParticleHasItsKernel) {
  const double volume = 0.04, radius = map_radius * std::sqrt(volume);  // 0.5: 100 pixels
  Gas gas;
  gas.add({0.5, 0.5, 0}, volume, 7);
  const PictureFrame frame = unit_frame(2, false, 200);
  const FieldMap map = project(gas.view(), frame);
  for (const int i : {3, 50, 99, 140}) {
    const double s = std::hypot((i + 0.5) / 200 - 0.5, 0.5 / 200) / radius;
    // The integral of (1 - s^2)^3 over a circle of radius 1 is pi / 4.
    const double kernel = volume / (radius * radius) * 4 / std::numbers::pi * std::pow(1 - s * s, 3);
    EXPECT_NEAR(map.cover[static_cast<std::size_t>(200 * 100 + i)], kernel, 1e-8);
    EXPECT_DOUBLE_EQ(map.values[static_cast<std::size_t>(200 * 100 + i)], 7);
  }
  EXPECT_TRUE(std::isnan(map.values[0])) << "no gas in the corner";
}

TEST(Projection, SlicesAddUpToTheVolume) {
  Gas gas;
  gas.add({0.5, 0.5, 0.5}, 1e-3, 1);  // a radius of 0.25
  PictureFrame frame = unit_frame(3, false, 50);
  constexpr int slices = 80;
  double sum = 0;
  for (int k = 0; k < slices; ++k) {
    frame.z = (k + 0.5) / slices;
    sum += integral(frame, project(gas.view(), frame).cover) / slices;
  }
  // Between the radius and 1.5 pixels, 0.03, the discs of the ends are drawn larger, with their area.
  EXPECT_NEAR(sum, 1e-3, 1e-9);
}

TEST(Projection, ImagesAreSeenAlongPeriodicAxes) {
  Gas edge, middle;
  edge.add({0.01, 0.98, 0.99}, 1e-3, 1);
  middle.add({0.51, 0.48, 0.49}, 1e-3, 1);
  PictureFrame frame = unit_frame(3, true, 20);
  frame.z = 0.02;
  const FieldMap corner = project(edge.view(), frame);
  frame.z = 0.52;
  const FieldMap inside = project(middle.view(), frame);
  for (std::size_t j = 0; j < 20; ++j)
    for (std::size_t i = 0; i < 20; ++i)
      EXPECT_NEAR(corner.cover[20 * j + i], inside.cover[20 * ((j + 10) % 20) + (i + 10) % 20], 1e-10);
}

TEST(Projection, AWindowShowsAPartOfTheWhole) {
  const Gas gas = lattice(2, 10, [](const Array3& x) { return x[0] * x[1]; });
  const PictureFrame all = unit_frame(2, true, 64);
  PictureFrame part = all;
  part.lower = {0.25, 0.5};
  part.size = {0.5, 0.25};
  part.pixels = {32, 16};
  const FieldMap whole = project(gas.view(), all), window = project(gas.view(), part);
  for (std::size_t j = 0; j < 16; ++j)
    for (std::size_t i = 0; i < 32; ++i)
      EXPECT_NEAR(window.values[32 * j + i], whole.values[64 * (j + 32) + i + 16], 1e-12);
}

TEST(Projection, WhatIsNoNumberIsLeftOut) {
  Gas gas = lattice(2, 8, [](const Array3&) { return 1.0; });
  const FieldMap before = project(gas.view(), unit_frame(2, true, 16));
  gas.add({0.5, 0.5, 0}, std::nan(""), 1);
  gas.add({0.5, 0.5, 0}, 1.0, std::numeric_limits<double>::infinity());
  EXPECT_EQ(project(gas.view(), unit_frame(2, true, 16)).values, before.values);
}

}  // namespace
}  // namespace sphk
