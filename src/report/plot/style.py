"""Looks of all figures: colours that colour-blind readers tell apart (Okabe and Ito), sizes readable at half size."""

import re

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

PARTICLES = "#9ab8d3"
MEAN = "#0072b2"
EXACT = "#d55e00"
LINES = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"]
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
})

# Axis label of every quantity a figure can show; with_unit() adds the unit.
LABELS = {
    "rho": r"density $\rho$",
    "P": r"pressure $P$",
    "u": r"specific thermal energy $u$",
    "A": r"entropy function $A$",
    "x": r"$x$",
    "y": r"$y$",
    "R": r"cylindrical radius $R$",
    "r": r"radius $r$",
}

# Axis label of the velocity that is shown along each abscissa.
VELOCITIES = {
    "x": r"velocity $v_x$",
    "y": r"velocity $v_x$",
    "R": r"azimuthal velocity $v_\varphi$",
    "r": r"radial velocity $v_r$",
}


def unit_of(item, quantity):
    """The unit of a quantity in a work order's run, for use behind a number or a name; empty: code units."""
    unit = (item.get("units") or {}).get(quantity, "")
    unit = re.sub(r"\^(-?[\d.]+)", r"$^{\1}$", re.sub(r"\b1e(-?\d+)", r"10$^{\1}$", unit))
    return f" [{unit}]".replace("sun", r"$_\odot$").replace("earth", r"$_\oplus$") if unit else ""


def with_unit(label, item, quantity):
    return label + unit_of(item, quantity)


def label_of(item, quantity):
    """The axis label of a quantity, with its unit."""
    label = VELOCITIES[item["abscissa"]] if quantity == "v" else LABELS.get(quantity, quantity)
    return with_unit(label, item, "x" if quantity in ("y", "R", "r") else quantity)


def time_of(item):
    return f"t = {item['time']:.4g}{unit_of(item, 't')}"


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


def save(figure, path):
    figure.savefig(path, bbox_inches="tight")
    plt.close(figure)
    print(path)
