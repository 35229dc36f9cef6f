# SPDX-License-Identifier: BSD-3-Clause
"""Maps of omega^2/(k^2 c^2) over wave number and support radius, as R10 Figs. 1-3."""

import numpy as np
from matplotlib.colors import SymLogNorm

from .style import UNSTABLE, plt, save


def draw_stability(work):
    panels, low, high = work["stability"], *work["h"]
    kinds = list(panels[0]["waves"])
    figure, grid = plt.subplots(len(kinds), len(panels), figsize=(4.6 * len(panels) + 1.6, 4.2 * len(kinds) + 0.6),
                                squeeze=False, sharex=True, sharey=True, constrained_layout=True)
    for row, kind in zip(grid, kinds):
        for axes, panel in zip(row, panels):
            values = np.array(panel["waves"][kind], dtype=float)
            image = axes.imshow(values, origin="lower", aspect="auto", extent=(0, 1, low, high), cmap=UNSTABLE,
                                norm=SymLogNorm(linthresh=1e-3, vmin=-1, vmax=1))
            kappa = (np.arange(values.shape[1]) + 0.5) / values.shape[1]
            support = low + (np.arange(values.shape[0]) + 0.5) / values.shape[0] * (high - low)
            if np.nanmin(values) < 0 < np.nanmax(values):
                axes.contour(kappa, support, values, levels=[0], colors="black", linewidths=1)
            axes.axhline(work["mark"], color="black", ls=":", lw=1.2)
            axes.grid(False)
            axes.set_title(f"{kind}, $k$ along {panel['direction']}")
    for axes in grid[-1]:
        axes.set_xlabel(r"$\kappa\,\Delta x/\pi$")
    for row in grid:
        row[0].set_ylabel(r"support radius $h/\Delta x$")
    bar = figure.colorbar(image, ax=grid, label=r"$\omega^2/(k^2c^2)$; below 0: unstable")
    bar.set_ticks([-1, -0.1, -0.01, -1e-3, 0, 1e-3, 0.01, 0.1, 1])
    bar.set_ticklabels(["-1", "-0.1", "-0.01", "-0.001", "0", "0.001", "0.01", "0.1", "1"])
    figure.suptitle(work["title"], fontsize=15)
    save(figure, work["out"])
