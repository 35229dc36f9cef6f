"""Particles as light points, their means in bins, and the exact solution, one panel a field."""

import numpy as np
from style import EXACT, MEAN, PARTICLES, label_of, panels_of, save, share_limits, time_of

MOST_POINTS = 20000
BINS = 50


def bin_means(s, y, low, high):
    """Centres and means of the occupied bins of width (high - low) / BINS."""
    index = np.floor((s - low) / (high - low) * BINS).astype(int)
    count = np.bincount(index, minlength=BINS)
    total = np.bincount(index, weights=y, minlength=BINS)
    centre = low + (np.arange(BINS) + 0.5) * (high - low) / BINS
    return centre[count > 0], total[count > 0] / count[count > 0]


def limits(values):
    """An axis range with a margin; at least wide enough that round-off does not look like structure."""
    low, high = float(np.min(values)), float(np.max(values))
    margin = max(0.06 * (high - low), 1e-3 * max(abs(low), abs(high), 1e-12))
    return low - margin, high + margin


def draw_field(axes, snapshot, name, point=None, mean=5, edge=1.3, line=1.8):
    """Particles, means and exact solution; the sizes of their marks in points."""
    item, low, high = snapshot.item, snapshot.item["from"], snapshot.item["to"]
    s, y = snapshot.abscissa(), snapshot.value(name)
    inside = (s >= low) & (s < high) & np.isfinite(y)
    s, y = s[inside], y[inside]
    shown = np.random.default_rng(1).permutation(len(s))[:MOST_POINTS]
    axes.plot(s[shown], y[shown], ".", ms=point or (5 if len(s) < 3000 else 3), color=PARTICLES, mew=0, rasterized=True, label="particles")
    heights = list(y)
    if len(s):
        axes.plot(*bin_means(s, y, low, high), "o", ms=mean, mfc="white", mec=MEAN, mew=edge, label="mean in bins")
    exact = item["exact"]
    if exact and name in exact:
        axes.plot(exact["abscissa"], exact[name], "-", lw=line, color=EXACT, label="exact")
        heights += exact[name]
    if heights:
        axes.set_ylim(*limits(heights))
    axes.set_xlim(low, high)


def draw_panel(axes, snapshot, name, error):
    draw_field(axes, snapshot, name)
    item = snapshot.item
    axes.set(xlabel=label_of(item, item["abscissa"]), ylabel=label_of(item, name))
    axes.set_title(f"$L_1$ = {error:.3g}" if error is not None else "")


def add_legend(figure, axes, rows):
    """One for all panels, below them."""
    handles, texts = axes.get_legend_handles_labels()
    figure.legend(handles, texts, loc="lower center", bbox_to_anchor=(0.5, -0.005), ncol=len(texts), markerscale=1.8)
    figure.get_layout_engine().set(rect=(0, 0.08 / rows, 1, 1 - 0.08 / rows), w_pad=0.12)


def draw_profiles(snapshot, errors, path):
    """`errors`: the L1 norms by field name at this time, as the run recorded them."""
    item = snapshot.item
    names = [name for name in item["fields"] if snapshot.can_show(name)]
    figure, panels, rows = panels_of(len(names), 3, 4.9, 4.1, header=0.9)
    for axes, name in zip(panels, names):
        draw_panel(axes, snapshot, name, errors.get(name))
    figure.suptitle(f"{item['title']}, {time_of(item)}", fontsize=15)
    add_legend(figure, panels[0], rows)
    save(figure, path)


def draw_one_field(snapshots, errors, name, path):
    """Field `name` of several runs, a panel each on one scale, as V10 Fig. 4. `errors`: the L1 norm of each, or None."""
    figure, panels, rows = panels_of(len(snapshots), 3, 5.2, 4.0, header=0.9, sharex=True)
    for axes, snapshot, error in zip(panels, snapshots, errors):
        draw_panel(axes, snapshot, name, error)
        axes.set_title(f"{snapshot.item['label']}, {axes.get_title()}" if error is not None else snapshot.item["label"])
    share_limits(panels)
    add_legend(figure, panels[0], rows)
    save(figure, path)
