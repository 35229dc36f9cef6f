#include "kernels/smoothing/cubic_spline.hpp"

// A smoothing kernel at an integer q.
const auto at_zero = sphk::CubicSpline{}(0);
