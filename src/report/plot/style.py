"""Looks of all figures: colours that colour-blind readers tell apart (Okabe and Ito), sizes readable at half size."""

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

# Axis label of every quantity a figure can show; code units throughout.
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


def number(value):
    """A short number for titles: 0.0367, 1.2e-06."""
    return f"{value:.3g}"


def save(figure, path):
    figure.savefig(path, bbox_inches="tight")
    plt.close(figure)
    print(path)
