// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/smoothing/cubic_spline.hpp"

// A smoothing kernel at an integer q.
const auto at_zero = sphk::CubicSpline{}(0);
