# SPDX-License-Identifier: BSD-3-Clause
"""Looks of all figures: colours that colour-blind readers tell apart (Okabe and Ito), sizes readable at half size."""

import os
import re
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullFormatter

PARTICLES = "#9ab8d3"
MEAN = "#0072b2"
EXACT = "#d55e00"
AXES = {"x": "#000000", "y": EXACT, "z": MEAN}  # a vector's components, as S12 Fig. 5
NOTE, OTHERS, BAND = "#555555", "#8a8a8a", "#dcdcdc"  # words in a figure, marks and lines that stand back
LINES = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"]
SEQUENTIAL, DIVERGING, UNSTABLE = "viridis", "RdBu_r", "RdBu"  # maps of colours that the colour-blind read, too
MARKERS = ["o", "s", "^", "D", "v", "P", "X"]

plt.rcParams.update({
    "figure.dpi": 160,
    "font.size": 13,
    "axes.titlesize": 13,
    "axes.labelsize": 14,
    "legend.fontsize": 12,
    "axes.grid": True,
    "grid.color": "#e4e4e4",
    "grid.linewidth": 0.8,
    "axes.axisbelow": True,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "legend.frameon": False,
    "mathtext.fontset": "dejavusans",
    "pdf.fonttype": 42,  # fonts are embedded, as papers want them
    "ps.fonttype": 42,
})

# Axis label of every quantity a figure can show; label_of() adds the unit.
LABELS = {
    "rho": r"density $\rho$",
    "P": r"pressure $P$",
    "u": r"specific thermal energy $u$",
    "A": r"entropy function $A$",
    "m": r"mass $m$",
    "h": r"support radius $h$",
    "alpha": r"dissipation parameter $\alpha$",
    "div_v": r"$\nabla\cdot v$",
    "x": r"$x$",
    "y": r"$y$",
    "R": r"cylindrical radius $R$",
    "r": r"radius $r$",
}
VELOCITY, ERROR = "v", "E_0"
VECTORS = {"v": VELOCITY, "Velocities": VELOCITY, "E0": ERROR}
COMPONENTS = {VELOCITY: "velocity $v_{%s}$", ERROR: "$E_{0,%s}$"}
WAYS = {"R": "radial ", "r": "radial ", "phi": "azimuthal "}  # which way a component points
LENGTHS = {"y": "x", "R": "x", "r": "x", "h": "x"}  # have the unit of x
NEVER_NEGATIVE = {"rho", "P", "u", "A", "m", "h"}
VANISHING = {"rho", "P"}  # are 0 where there is no gas
WITHIN_ONE = {"alpha"}  # from 0 to 1, or somewhat more


def unit_of(item, quantity):
    """The unit of a quantity in a work order's run, for use behind a number or a name; empty: code units."""
    unit = (item.get("units") or {}).get(LENGTHS.get(quantity, quantity), "")
    unit = re.sub(r"\^(-?[\d.]+)", r"$^{\1}$", re.sub(r"\b1e(-?\d+)", r"10$^{\1}$", unit))
    return f" [{unit}]".replace("sun", r"$_\odot$").replace("earth", r"$_\oplus$") if unit else ""


def with_unit(label, item, quantity):
    return label + unit_of(item, quantity)


def time_of(item):
    return f"t = {item['time']:.4g}{unit_of(item, 't')}"


def field_label(item, name):
    """Axis label of a field or coordinate of a work order's run, with its unit."""
    base = name.strip("|").rpartition("_")[0] or name.strip("|")
    quantity = "v" if VECTORS.get(base) == VELOCITY else name
    return with_unit(label_of(name, item.get("parts", {}).get(name, "")), item, quantity)


def label_of(name, part=""):
    """Axis label of a field; of a vector's component, whose name may end with its part; of a vector's modulus."""
    base, _, end = name.rpartition("_")
    if base in VECTORS:
        name, part = base, end
    symbol = VECTORS.get(name.strip("|"))
    if symbol is None:
        return LABELS.get(name, name.replace("_", " "))
    if part in ("", "modulus"):
        return f"$|{symbol}|$"
    return WAYS.get(part, "") + COMPONENTS[symbol] % part.replace("phi", r"\varphi")


def panels_of(count, most_columns, width, height, header=0.0, **options):
    """A figure of `count` panels, each of that size in inches, and its number of rows; what is left of the grid stays
    empty."""
    columns = min(count, most_columns)
    rows = -(-count // columns)
    figure, grid = plt.subplots(rows, columns, figsize=(width * columns, height * rows + header), squeeze=False,
                                constrained_layout=True, **options)
    for axes in grid.flat[count:]:
        axes.axis("off")
    return figure, grid.flat[:count], rows


def share_limits(panels, decades=None):
    """One range of y for all, so that they compare; of no more than so many decades."""
    lows, highs = zip(*(axes.get_ylim() for axes in panels))
    low, high = min(lows), max(highs)
    for axes in panels:
        axes.set_ylim(max(low, high / 10**decades) if decades else low, high)


def set_view(panels, view):
    """The range and scale of y that the user asks for."""
    for axes in panels:
        if view["log"]:
            axes.set_yscale("log")
        if view["range"]:
            axes.set_ylim(*view["range"])


def short(value):
    """0.0025, 310, 2000, 5.2 M"""
    for unit, name in ((1e12, " T"), (1e9, " G"), (1e6, " M"), (1e3, " k")):
        if value >= unit and value >= 1e4:
            return f"{value / unit:.3g}{name}"
    return f"{value:.3g}" if value < 1000 else f"{value:.0f}"


def plain_ticks(axis, low, high):
    """Numbers as they are read on a logarithmic axis, 1, 2 and 5 of a decade where there are few decades."""
    decades = np.log10(max(high / max(low, 1e-300), 1))
    axis.set_major_locator(MaxNLocator(4) if decades < 0.6 else LogLocator(subs=(1, 2, 5) if decades < 2.5 else (1,)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: short(value)))
    axis.set_minor_formatter(NullFormatter())


def tell(path):
    """Prints the name of a file that is ready."""
    try:
        print(path, flush=True)
    except BrokenPipeError:  # whoever read the names has gone: the figures are still wanted
        sys.stdout = open(os.devnull, "w", encoding="utf-8")


def save(figure, path):
    figure.savefig(path, bbox_inches="tight")
    plt.close(figure)
    tell(path)
