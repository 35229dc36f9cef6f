# SPDX-License-Identifier: BSD-3-Clause
"""history.csv: reading it, and the figure of conservation, energies, errors and measures against time."""

import csv

import numpy as np

from .style import LINES, MARKERS, NOTE, panels_of, plain_ticks, plt, save, with_unit

DRIFTS = {
    "energy_drift": "energy",
    "momentum_drift": "momentum",
    "angular_momentum_drift": "angular momentum",
    "mass_drift": "mass",
}
SYMBOLS = {"v": "$v$", "rho": r"$\rho$", "P": "$P$"}
PERCENT, NEAR = 0.01, 0.01
ENERGIES = {"total_energy": "total", "kinetic_energy": "kinetic", "thermal_energy": "thermal"}

MEASURES = {
    "M": "$M$: amplitude of the mode in $v_y$",
    "W": "$W$: width of the mixed zone",
    "mixA": "mass of mixed entropy",
    "crossed": "dense gas outside its layer",
    "cloud_mass": "mass that is still cloud",
    "cold_share": "cloud's gas below $T_{wind}/2$",
    "cloud_velocity": "$v_x$ of the cloud's gas",
    "peak_density": r"largest density $\rho$",
    "E0_mean": "mean $|E_0|$",
    "E0_95": "$|E_0|$: 95 % have less",
    "E0_max": "largest $|E_0|$",
    "E0_boundary": "mean $|E_0|$ where fluids meet",
    "E0_bulk": "mean $|E_0|$ elsewhere",
    "R_error": "mean $|R - 1|$",
    "V_error": "mean $|V - 1|$",
    "nearest_mean": "nearest neighbour, spacings",
    "nearest_5": "nearest neighbour: 5 % are closer",
}
GROWING = {"M"}  # exponentially: drawn on a logarithmic axis


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


def measures_of(history):
    """The scene's own columns: they follow the standard ones, of which mass_drift is the last."""
    names = list(history)
    own = names[names.index("mass_drift") + 1:] if "mass_drift" in names else []
    return [name for name in own if not name.startswith("l1_") and np.isfinite(history[name]).any()]


def draw_lines(axes, history, names, first=0):
    """One line a column, from row `first` on."""
    for k, (name, label) in enumerate(names.items()):
        axes.plot(history["time"][first:], history[name][first:], "-", marker=MARKERS[k % len(MARKERS)], ms=4, lw=1.6,
                  color=LINES[k % len(LINES)], label=label)
    axes.locator_params(axis="x", nbins=5)
    axes.set_xlabel(r"time $t$")
    if len(names) > 1:
        axes.legend(loc="lower left", bbox_to_anchor=(-0.02, 1.0), ncol=2,
                    columnspacing=1.0, handlelength=1.4, fontsize=10.5)


def scale_drifts(axes, drifts):
    """A logarithmic axis for these arrays, which ends where they end, not at what is exactly 0; one per cent is on it
    where they come near that."""
    seen = np.concatenate([drift[drift > 0] for drift in drifts] + [np.empty(0)])
    if len(seen):
        axes.set_yscale("log", nonpositive="mask")
        axes.set_ylim(0.5 * seen.min(), 2 * max(seen.max(), PERCENT if seen.max() > NEAR * PERCENT else 0))
    else:
        axes.set(yticks=[], ylim=(1, 2))
        axes.annotate("no drift at all", (0.5, 0.5), xycoords="axes fraction", ha="center", color=NOTE)


def draw_drifts(axes, history):
    """How well the run conserves, as S12 fig. 10."""
    drifts = {name: label + ("" if (history[name][1:] > 0).any() else ": 0") for name, label in DRIFTS.items()
              if name in history}
    draw_lines(axes, history, drifts, first=1)
    scale_drifts(axes, [history[name][1:] for name in drifts])
    axes.set_ylabel("relative drift since the start")


def draw_energies(axes, history):
    """What each energy gains or loses: beside a large thermal energy the kinetic one would be a line at 0."""
    gains = {"time": history["time"]} | {name: history[name] - history[name][0] for name in ENERGIES}
    draw_lines(axes, gains, {name: f"{label}, from {history[name][0]:.3g}" for name, label in ENERGIES.items()})
    axes.set_ylabel("change of the energy")


def draw_errors(axes, history):
    draw_lines(axes, history, {"l1_" + name: symbol for name, symbol in SYMBOLS.items() if "l1_" + name in history})
    axes.set_ylabel(r"$L_1$ error")


def draw_references(axes, history, name, references):
    """Marks, or bars from low to high, where converged runs tell what the measure should be."""
    shown = [r for r in references if r["measure"] == name and r["time"] <= history["time"][-1] * (1 + 1e-6)]
    if not shown:
        return
    low, high = (np.array([r[side] for r in shown]) for side in ("low", "high"))
    axes.errorbar([r["time"] for r in shown], (low + high) / 2, yerr=(high - low) / 2, fmt="D", ms=7, mfc="none",
                  color="black", capsize=4, label="converged runs", zorder=3)
    axes.legend(loc="best")


def draw_measure(axes, history, name, references):
    label = MEASURES.get(name, name.replace("_", " "))
    if any(r["over_start"] for r in references if r["measure"] == name):
        history = {**history, name: history[name] / history[name][0]}
        label += ", over its start"
    draw_lines(axes, history, {name: name})
    draw_references(axes, history, name, references)
    axes.set_ylabel(label)
    if name in GROWING and (history[name] > 0).all():
        axes.set_yscale("log")
        plain_ticks(axes.yaxis, *axes.get_ylim())


def draw_conservation(runs, path):
    """The drifts of several runs, each over its own length, as S12 fig. 10."""
    figure, grid = plt.subplots(2, 2, figsize=(11.2, 8.4), sharex=True, constrained_layout=True)
    histories = [read_history(run["history"]) for run in runs]
    for axes, (name, label) in zip(grid.flat, DRIFTS.items()):
        drifts = []
        for k, history in enumerate(histories):
            if name not in history or len(history["time"]) < 2:
                continue
            time = history["time"]
            drifts.append(history[name][1:])
            axes.plot((time[1:] - time[0]) / (time[-1] - time[0]), drifts[-1], "-", marker=MARKERS[k % len(MARKERS)],
                      ms=4, lw=1.6, color=LINES[k % len(LINES)], label=runs[k]["title"])
        scale_drifts(axes, drifts)
        if axes.get_ylim()[1] > PERCENT and axes.get_yscale() == "log":
            axes.axhline(PERCENT, color=NOTE, lw=1, ls=":")
            axes.annotate("1 %", (1.01, PERCENT), xycoords=axes.get_yaxis_transform(), color=NOTE, fontsize=11,
                          va="center")
        axes.set_ylabel("relative drift of " + label)
    for axes in grid[-1]:
        axes.set_xlabel("time over the run's length")
    legend_rows = -(-len(runs) // 3)
    figure.get_layout_engine().set(rect=(0, 0, 1, 1 - 0.035 * legend_rows), w_pad=0.12, h_pad=0.12)
    figure.legend(*grid[0][0].get_legend_handles_labels(), loc="upper center", ncol=3)
    save(figure, path)


def draw_history(history, references, run, path):
    """`run`: the work order's item of one of its snapshots."""
    panels = [draw_drifts, draw_energies]
    if any("l1_" + name in history for name in SYMBOLS):
        panels.append(draw_errors)
    panels += [lambda axes, history, name=name: draw_measure(axes, history, name, references) for name in measures_of(history)]
    figure, grid, _ = panels_of(len(panels), 3, 5.6, 4.6, header=0.4)
    for axes, draw in zip(grid, panels):
        draw(axes, history)
        axes.set_xlabel(with_unit(axes.get_xlabel(), run, "t"))
    grid[panels.index(draw_energies)].set_ylabel(with_unit("change of the energy", run, "energy"))
    figure.get_layout_engine().set(w_pad=0.12, h_pad=0.12)
    figure.suptitle(run["title"], fontsize=15)
    save(figure, path)
