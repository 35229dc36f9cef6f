// SPDX-License-Identifier: BSD-3-Clause
#include "src/schemes/sph.hpp"

// The rates come before the equation of state, whose pressures the terms read.
struct Wrong : sphk::Recipe<sphk::EntropyForm, sphk::ClassicDensity, sphk::Sph::Entropy::RateTerms,
                            sphk::Passes<sphk::KickDrift, sphk::SortedCells, sphk::SmoothingLength, sphk::Rates,
                                         sphk::StateEquation, sphk::BalsaraFactor, sphk::KickTimeStep>> {};
static_assert(sphk::in_order<Wrong>);
