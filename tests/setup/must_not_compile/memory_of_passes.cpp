// SPDX-License-Identifier: BSD-3-Clause
#include "src/schemes/sph.hpp"

// Drifting needs the accelerations of the step before, and no rates are computed.
struct Wrong : sphk::Recipe<sphk::EntropyForm, sphk::ClassicDensity, sphk::Sph::Entropy::RateTerms,
                            sphk::Passes<sphk::KickDrift, sphk::SortedCells, sphk::SmoothingLength>> {};
static_assert(sphk::in_order<Wrong>);
