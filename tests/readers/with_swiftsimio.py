# SPDX-License-Identifier: BSD-3-Clause
"""swiftsimio.load, project_gas, and slice_gas through the middle of the box."""

import numpy as np
import swiftsimio
from runs import T_END, check_places, near
from swiftsimio.visualisation import project_gas, slice_gas

PIXELS = 128
SAME = 1e-5  # it takes the nearest of the units that it has names for


def check_swiftsimio(truth):
    length, mass, time = truth.units
    data = swiftsimio.load(truth.file)
    facts, gas = data.metadata, data.gas
    near(facts.t.to_value("s"), T_END * time, SAME, "time")
    assert facts.hydro_scheme["Dimension"][0] == truth.dimension
    box = facts.boxsize.to_physical().to_value("cm") / length
    check_places(gas.coordinates.to_physical().to_value("cm") / length, box, truth, SAME)
    near(gas.masses.to_physical().to_value("g").sum(), truth.mass * mass, SAME, "mass")
    densities = gas.densities.to_physical().to_value(f"g/cm**{truth.dimension}")
    near(densities, truth.fields["Densities"] * mass / length**truth.dimension, SAME, "density")
    near(gas.pressures.to_physical().in_cgs().value,
         truth.fields["Pressures"] * mass * length ** (2 - truth.dimension) / time**2, SAME, "pressure")
    along = project_gas(data, resolution=PIXELS).to_physical().to_value("g/cm**2")
    near(along.sum() * (box[:2].max() * length / PIXELS) ** 2, truth.mass * mass, 0.02, "mass of the projection")
    middle = 0.5 * facts.boxsize[2]
    masses = np.array(slice_gas(data, resolution=PIXELS, z_slice=middle).to_physical().in_cgs())
    assert (masses > 0).any(), "the slice is blank"
    if "plane" in truth.file:
        assert (masses > 0.5 * masses.mean()).all(), "gas everywhere"
