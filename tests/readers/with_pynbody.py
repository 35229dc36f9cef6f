# SPDX-License-Identifier: BSD-3-Clause
"""pynbody.load, and an image of the gas around the middle of the box."""

import numpy as np
import pynbody
from pynbody.plot import sph
from runs import T_END, check_places, near


def check_pynbody(truth):
    length, mass, time = truth.units
    data = pynbody.load(truth.file)
    assert type(data).__name__ == "SwiftSnap"
    near(data.properties["time"].in_units("s"), T_END * time, 1e-6, "time")
    gas = data.gas
    order = np.argsort(gas["iord"])
    box = truth.header("BoxSize")  # which it shows of cosmological runs alone
    check_places(np.array(gas["pos"].in_units("cm"))[order] / length, box, truth)
    near(gas["mass"].in_units("g").sum(), truth.mass * mass, 1e-12, "mass")
    rho = np.array(gas["rho"].in_units(f"g cm**-{truth.dimension}"))[order]
    near(rho, truth.fields["Densities"] * mass / length**truth.dimension, 1e-12, "density")
    gas["pos"] -= gas["pos"].mean(axis=0)
    width = f"{box[0] * length:.17g} cm"
    image = sph.image(gas, qty="rho", width=width, return_array=True, noplot=True, log=False, resolution=64)
    assert np.nanmax(image) > 0, "the image is blank"
