// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "src/engine/particle_set.hpp"

namespace sphk {

// Initial conditions whose density varies smoothly along y (V10 sec 4.3), for any scene: a profile, and two ways to lay
// out equal masses that follow it, on columns or on rows.

/// V10 eq 16-20 for a boundary at 0: from 0 at distance -width/2 and below to 1 at width/2 and above, along an arctan
/// whose argument runs from -beta to beta.
double arctan_step(double distance, double width, double beta = 10);

/// `along` columns of equal spacing in x, each with `rows` particles whose y follow the density. The plane has the
/// given lower corner and extents; rho(y) > 0.
std::vector<Array3> columns_of(const std::function<double(double y)>& rho, Array3 lower, Array3 size, int along,
                               int rows);

/// Rows of equal y, about `particles` in all, as far apart as the particles on them: squares of the mass that a
/// particle stands for, m = rho dx dy (V10 eq 21-22).
std::vector<Array3> rows_of(const std::function<double(double y)>& rho, Array3 lower, Array3 size, double particles);

}  // namespace sphk
