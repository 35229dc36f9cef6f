# SPDX-License-Identifier: BSD-3-Clause
"""yt.load, all_data, SlicePlot and ProjectionPlot."""

import numpy as np
import yt
from runs import T_END, check_places, near

yt.set_log_level(50)


def image_of(plot):
    return np.array(plot.frb["gas", "density"])


def check_yt(truth):
    length, mass, time = truth.units
    data = yt.load(truth.file)
    assert type(data).__name__ == "SwiftDataset" and data.dimensionality == 3
    assert float(data.current_time.to("code_time")) == T_END
    near([data.length_unit.to_value("cm"), data.mass_unit.to_value("g"), data.time_unit.to_value("s")], truth.units, 1e-12,
         "units")
    gas = data.all_data()
    order = np.argsort(gas["PartType0", "ParticleIDs"].astype(int))
    assert len(order) == len(truth.x), f"{len(order)} particles"
    box = data.domain_right_edge.to_value("code_length")
    check_places(gas["PartType0", "Coordinates"].to_value("code_length")[order], box, truth)
    near(gas["gas", "mass"].to_value("g").sum(), truth.mass * mass, 1e-12, "mass")
    near(gas["gas", "density"].to_value("g/cm**3")[order], truth.fields["Densities"] * mass / length**3, 1e-12, "density")
    check_pictures(data, truth, box)


def check_pictures(data, truth, box):
    length, mass, _ = truth.units
    rho = truth.fields["Densities"] * mass / length**3
    cut = image_of(yt.SlicePlot(data, "z", ("gas", "density")))
    shown = cut[np.isfinite(cut) & (cut > 0)]
    assert len(shown) > 0, "the slice is blank"
    assert shown.max() < 1.05 * rho.max(), f"the slice reaches {shown.max()}, the particles {rho.max()}"
    along = image_of(yt.ProjectionPlot(data, "z", ("gas", "density")))
    width = box[:2].max() if truth.dimension > 1 else box[0]
    total = np.nansum(along) / along.size * (width * length) ** 2
    near(total, truth.mass * mass, 0.02, "mass of the projection")
    if "plane" in truth.file:
        near(np.mean(cut), 1, 0.02, "mean of the slice")
