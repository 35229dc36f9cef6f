// SPDX-License-Identifier: BSD-3-Clause
#include "src/stability/limits.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace sphk {

namespace {

// From which contrasts on the limits were met. Boxes of 16 particles measure 80 of 100 at least, whatever cuts them.
constexpr double density_limit = 80, mass_limit = 100, pressure_limit = 100;

}  // namespace

std::vector<std::string> limit_remarks(const Contrasts& gas, const Method& method) {
  const auto may_be = [&](std::initializer_list<const char*> schemes) {
    return method.scheme.empty() || std::ranges::find(schemes, method.scheme) != schemes.end();
  };
  std::vector<std::string> remarks;
  if (gas.density >= density_limit && method.scheme != "osph-coherent")
    remarks.push_back(fmt::format(
        "gas of densities 1:{:.0f} lies side by side at one pressure: all schemes but osph-coherent take the "
        "density of the thin gas from the dense, and may tear it or end; --scheme osph-coherent --set "
        "sph.energy=energy keeps its pressure",
        gas.density));
  if (gas.mass >= mass_limit && may_be({"gadget2", "v10"}))
    remarks.push_back(fmt::format(
        "masses of particles that lie side by side differ by a factor of {:.4g}: gadget2 and v10 gain energy "
        "where such gas is shocked; sph, tsph, osph and the family of sphs do not",
        gas.mass));
  if (gas.pressure >= pressure_limit && may_be({"sphs"}) && method.energy != "energy")
    remarks.push_back(fmt::format(
        "pressures side by side differ by a factor of {:.2g}: with sph.energy=entropy sphs loses 4 to 10 % of "
        "the energy of a blast, however short its steps (S12: 5 %); sph.energy=energy and "
        "sphs-conservative conserve it",
        gas.pressure));
  if (gas.without_heat > 0 && may_be({"osph", "osph-coherent"}))
    remarks.push_back(fmt::format(
        "{} particles have no heat (u = 0): osph and osph-coherent, which weigh neighbours by it, take the observable "
        "density for theirs",
        gas.without_heat));
  if (method.signal == "v1" || method.signal == "v2")
    remarks.push_back(
        fmt::format("conductivity.signal = {} can carry heat from cold gas to hot{}", method.signal,
                    method.motion || method.signal == "v1"
                        ? ""
                        : ", and particles that cannot move to answer it run away (time.motion = false)"));
  return remarks;
}

}  // namespace sphk
