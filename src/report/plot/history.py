"""history.csv: reading it, and the figure of conservation, energies and errors against time."""

import csv

import numpy as np
from style import LINES, MARKERS, plt, save

DRIFTS = {
    "energy_drift": "energy",
    "momentum_drift": "momentum",
    "angular_momentum_drift": "angular momentum",
    "mass_drift": "mass",
}
SYMBOLS = {"v": "$v$", "rho": r"$\rho$", "P": "$P$"}
ENERGIES = {"total_energy": "total", "kinetic_energy": "kinetic", "thermal_energy": "thermal"}


def read_history(path):
    """The columns by name, as arrays."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    return {name: np.array([float(row[name]) for row in rows]) for name in (rows[0] if rows else {})}


def errors_at(history, time):
    """The L1 norms by field at the row whose time is nearest, when that is the same output."""
    if not len(history.get("time", [])):
        return {}
    times = history["time"]
    row = int(np.argmin(np.abs(times - time)))
    if abs(times[row] - time) > 1e-6 * max(np.ptp(times), 1e-300):
        return {}
    norms = {name[3:]: values[row] for name, values in history.items() if name.startswith("l1_")}
    return {name: norm for name, norm in norms.items() if np.isfinite(norm)}


def draw_lines(axes, history, names, first=0, floor=-np.inf):
    """One line a column, from row `first` on; values below `floor` sit on it: zeros on a logarithmic axis."""
    for k, (name, label) in enumerate(names.items()):
        values = np.maximum(history[name][first:], floor)
        axes.plot(history["time"][first:], values, "-", marker=MARKERS[k % len(MARKERS)], ms=4, lw=1.6,
                  color=LINES[k % len(LINES)], label=label)
    axes.locator_params(axis="x", nbins=5)
    axes.set_xlabel(r"time $t$")
    axes.legend(loc="lower left", bbox_to_anchor=(-0.02, 1.0), ncol=2 if len(names) % 3 else 3,
                columnspacing=1.2, handlelength=1.6)


def draw_history(history, title, path):
    errors = {"l1_" + name: symbol for name, symbol in SYMBOLS.items() if "l1_" + name in history}
    panels = 3 if errors else 2
    figure, axes = plt.subplots(1, panels, figsize=(5.6 * panels, 5.0), constrained_layout=True)
    drifts = {name: label for name, label in DRIFTS.items() if name in history}
    draw_lines(axes[0], history, drifts, first=1, floor=1e-17)
    axes[0].set_yscale("log")
    axes[0].set_ylabel("relative drift since the start")
    draw_lines(axes[1], history, ENERGIES)
    axes[1].set_ylabel("energy")
    if errors:
        draw_lines(axes[2], history, errors)
        axes[2].set_ylabel(r"$L_1$ error")
    figure.get_layout_engine().set(w_pad=0.12)
    figure.suptitle(title, fontsize=15)
    save(figure, path)
