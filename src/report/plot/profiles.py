"""Particles as light points, their means in bins, and the exact solution, one panel a field."""

import numpy as np
from style import EXACT, LABELS, MEAN, PARTICLES, VELOCITIES, number, plt, save

MOST_POINTS = 20000
BINS = 50


def bin_means(s, y, low, high):
    """Centres and means of the occupied bins of width (high - low) / BINS."""
    index = np.floor((s - low) / (high - low) * BINS).astype(int)
    count = np.bincount(index, minlength=BINS)
    total = np.bincount(index, weights=y, minlength=BINS)
    centre = low + (np.arange(BINS) + 0.5) * (high - low) / BINS
    return centre[count > 0], total[count > 0] / count[count > 0]


def field_label(item, name):
    return VELOCITIES[item["abscissa"]] if name == "v" else LABELS.get(name, name)


def limits(values):
    """An axis range with a margin; at least wide enough that round-off does not look like structure."""
    low, high = float(np.min(values)), float(np.max(values))
    margin = max(0.06 * (high - low), 1e-3 * max(abs(low), abs(high), 1e-12))
    return low - margin, high + margin


def draw_panel(axes, snapshot, name, error):
    item, low, high = snapshot.item, snapshot.item["from"], snapshot.item["to"]
    s, y = snapshot.abscissa(), snapshot.value(name)
    inside = (s >= low) & (s < high) & np.isfinite(y)
    s, y = s[inside], y[inside]
    shown = np.random.default_rng(1).permutation(len(s))[:MOST_POINTS]
    size = 5 if len(s) < 3000 else 3
    axes.plot(s[shown], y[shown], ".", ms=size, color=PARTICLES, mew=0, rasterized=True, label="particles")
    heights = list(y)
    if len(s):
        axes.plot(*bin_means(s, y, low, high), "o", ms=5, mfc="white", mec=MEAN, mew=1.3, label="mean in bins")
    exact = item["exact"]
    if exact and name in exact:
        axes.plot(exact["abscissa"], exact[name], "-", lw=1.8, color=EXACT, label="exact")
        heights += exact[name]
    if heights:
        axes.set_ylim(*limits(heights))
    axes.set_xlim(low, high)
    axes.set_xlabel(LABELS[item["abscissa"]])
    axes.set_ylabel(field_label(item, name))
    axes.set_title(f"$L_1$ = {number(error)}" if error is not None else "")


def draw_profiles(snapshot, errors, path):
    """`errors`: the L1 norms by field name at this time, as the run recorded them."""
    item = snapshot.item
    names = [name for name in item["fields"] if snapshot.can_show(name)]
    columns = min(len(names), 3)
    rows = -(-len(names) // columns)
    size = (4.9 * columns, 4.1 * rows + 0.9)
    figure, panels = plt.subplots(rows, columns, figsize=size, squeeze=False, constrained_layout=True)
    for axes, name in zip(panels.flat, names):
        draw_panel(axes, snapshot, name, errors.get(name))
    for axes in list(panels.flat)[len(names):]:
        axes.axis("off")
    handles, texts = panels.flat[0].get_legend_handles_labels()
    figure.suptitle(f"{item['title']}, t = {item['time']:.4g}", fontsize=15)
    figure.legend(handles, texts, loc="lower center", bbox_to_anchor=(0.5, -0.005), ncol=len(texts), markerscale=1.8)
    figure.get_layout_engine().set(rect=(0, 0.08 / rows, 1, 1 - 0.08 / rows), w_pad=0.12)
    save(figure, path)


def draw_one_field(snapshots, errors, name, path):
    """Field `name` of several runs, a panel each on one scale, as V10 Fig. 4. `errors`: the L1 norm of each, or None."""
    columns = min(len(snapshots), 3)
    rows = -(-len(snapshots) // columns)
    figure, panels = plt.subplots(rows, columns, figsize=(5.2 * columns, 4.0 * rows + 0.9), squeeze=False, sharex=True,
                                  constrained_layout=True)
    panels = list(panels.flat)
    for axes, snapshot, error in zip(panels, snapshots, errors):
        draw_panel(axes, snapshot, name, error)
        axes.set_title(f"{snapshot.item['label']}, {axes.get_title()}" if error is not None else snapshot.item["label"])
    used = panels[: len(snapshots)]
    low, high = min(a.get_ylim()[0] for a in used), max(a.get_ylim()[1] for a in used)
    for axes in used:
        axes.set_ylim(low, high)
    for axes in panels[len(snapshots):]:
        axes.axis("off")
    handles, texts = panels[0].get_legend_handles_labels()
    figure.legend(handles, texts, loc="lower center", bbox_to_anchor=(0.5, -0.005), ncol=len(texts), markerscale=1.8)
    figure.get_layout_engine().set(rect=(0, 0.08 / rows, 1, 1 - 0.08 / rows), w_pad=0.12)
    save(figure, path)
