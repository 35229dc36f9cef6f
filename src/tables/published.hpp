// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>
#include <vector>

namespace sphk {

/// Half a unit of the last digit of a printed number: 0.005 for "1.02".
double half_last_digit(const std::string& printed);

/// One number of a published table and what sphk computes for it.
struct PublishedValue {
  std::string row, quantity;
  std::string printed;  ///< as the paper prints it: its digits say how near is near
  double computed;

  double difference() const { return computed - std::stod(printed); }
  /// Within half a unit of the last printed digit.
  bool agrees() const { return std::abs(difference()) <= half_last_digit(printed) * (1 + 1e-9); }
};

struct PublishedTable {
  std::string key;    ///< short, a file's name
  std::string title;  ///< with paper and table
  std::string note;   ///< what the paper's numbers need to be read with; may be empty
  std::vector<PublishedValue> values;

  /// In lines for people, a star at what does not agree; and as CSV.
  std::string text() const;
  std::string csv() const;
};

/// S12 Table 1: densities of an even box of n^3 particles, on a cubic lattice and a glass, at the 95th, 50th and 5th
/// percentile.
PublishedTable density_errors(int n);
/// R10 Table 1: parameters of the HOCT kernels.
PublishedTable hoct_parameters();
/// V10 Table 1: coefficients of the LIQ kernels, from those that the engine's kernel is made of.
PublishedTable liq_coefficients();
/// What S12 Fig. 1 and eq 17 say of its kernels: parameters, and half-mass radii against each other.
PublishedTable half_mass_radii();

/// Radius in units of h that holds half of the mass of a smoothing kernel in 3D.
double half_mass_radius(const std::string& kernel);

}  // namespace sphk
