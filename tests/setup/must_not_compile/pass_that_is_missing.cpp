// SPDX-License-Identifier: BSD-3-Clause
#include "src/schemes/sphs.hpp"

// No pass fits the gradients that the switch reads.
struct Wrong : sphk::Recipe<sphk::EntropyForm, sphk::TermSet<>, sphk::Sphs::Entropy::RateTerms,
                            sphk::Step<sphk::StateEquation, sphk::ConvergenceSwitch>> {};
static_assert(sphk::in_order<Wrong>);
