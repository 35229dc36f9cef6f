// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "src/engine/particle_set.hpp"

namespace sphk::test {

/// Of the same gas: how many of them there are in a unit of before.
struct Units {
  double length, mass, time;
};

inline ParticleSet in_units(ParticleSet gas, const Units& units) {
  gas.time *= units.time;
  for (std::size_t d = 0; d < 3; ++d) gas.box.lower[d] *= units.length, gas.box.size[d] *= units.length;
  for (Array3& x : gas.x)
    for (double& each : x) each *= units.length;
  for (Array3& v : gas.v)
    for (double& each : v) each *= units.length / units.time;
  for (double& m : gas.m) m *= units.mass;
  for (double& u : gas.u) u *= std::pow(units.length / units.time, 2);
  for (double& h : gas.h) h *= units.length;
  return gas;
}

inline double factor(const UnitExponents& unit, const Units& units) {
  return std::pow(units.length, unit.length) * std::pow(units.mass, unit.mass) * std::pow(units.time, unit.time);
}

}  // namespace sphk::test
