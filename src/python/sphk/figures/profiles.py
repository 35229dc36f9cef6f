# SPDX-License-Identifier: BSD-3-Clause
"""Particles as light points, their means in bins, and the exact solution, one panel a field."""

import numpy as np

from .style import (AXES, EXACT, LINES, MEAN, NOTE, PARTICLES, field_label, label_of, panels_of, save, set_view,
                    share_limits, time_of)

MOST_POINTS = 20000
BINS = 50
RARE, FAR = 0.5, 0.3  # per cent of the particles at either end, and how far beyond the others they still set an axis


def bin_means(s, y, low, high):
    """Centres and means of the occupied bins of width (high - low) / BINS."""
    index = np.floor((s - low) / (high - low) * BINS).astype(int)
    count = np.bincount(index, minlength=BINS)
    total = np.bincount(index, weights=y, minlength=BINS)
    centre = low + (np.arange(BINS) + 0.5) * (high - low) / BINS
    return centre[count > 0], total[count > 0] / count[count > 0]


def limits(values, surely=()):
    """An axis range with a margin, at least wide enough that round-off does not look like structure. It holds all of
    `surely`, and of the values all but rare ones far out."""
    low, high = np.percentile(values, [RARE, 100 - RARE]) if len(values) else (np.inf, -np.inf)
    low, high = float(np.min(surely, initial=low)), float(np.max(surely, initial=high))
    if len(values):
        spread = high - low
        low, high = min(low, max(values.min(), low - FAR * spread)), max(high, min(values.max(), high + FAR * spread))
    margin = max(0.06 * (high - low), 1e-3 * max(abs(low), abs(high), 1e-12))
    return low - margin, high + margin


def tell_hidden(axes, values):
    """How many particles lie beyond the axis, and how far."""
    low, high = axes.get_ylim()
    for beyond, extreme, place, end in ((values > high, values.max(initial=high), 1, "top"),
                                        (values < low, values.min(initial=low), 0, "bottom")):
        if beyond.any():
            axes.annotate(f"{'above' if place else 'below'}: {beyond.sum()}, to {extreme:.3g}", (0.98, place),
                          xycoords="axes fraction", ha="right", va=end, fontsize=10, color=NOTE)


def points_of(snapshot, name, among=True):
    """Coordinate and value of the particles in the scene's range; of those `among` alone."""
    s, y = snapshot.abscissa(), snapshot.value(name)
    inside = (s >= snapshot.item["from"]) & (s < snapshot.item["to"]) & np.isfinite(y) & among
    return s[inside], y[inside]


def some_of(s, y):
    """No more than can be seen, the same of every field."""
    shown = np.random.default_rng(1).permutation(len(s))[:MOST_POINTS]
    return s[shown], y[shown]


def exact_of(item, name):
    return item["exact"][name] if item["exact"] and name in item["exact"] else []


def limits_of(snapshot, name):
    """The range of y that shows a field of a snapshot."""
    if name == "E0":
        parts = [points_of(snapshot, f"E0_{part}")[1] for part in parts_of(snapshot)]
        low, high = limits(np.concatenate(parts))
        return low, high + 0.25 * (high - low)  # room for a legend
    return limits(points_of(snapshot, name)[1], exact_of(snapshot.item, name))


def draw_field(axes, snapshot, name, point=None, mean=5, edge=1.3, line=1.8):
    """Particles, means and exact solution; the sizes of their marks in points."""
    item, low, high = snapshot.item, snapshot.item["from"], snapshot.item["to"]
    s, y = points_of(snapshot, name)
    axes.plot(*some_of(s, y), ".", ms=point or (5 if len(s) < 3000 else 3), color=PARTICLES, mew=0, rasterized=True,
              label="particles")
    if len(s):
        axes.plot(*bin_means(s, y, low, high), "o", ms=mean, mfc="white", mec=MEAN, mew=edge, label="mean in bins")
    if len(exact := exact_of(item, name)):
        axes.plot(item["exact"]["abscissa"], exact, "-", lw=line, color=EXACT, label="exact")
    axes.set_xlim(low, high)
    axes.set_ylim(*limits(y, exact))


def parts_of(snapshot):
    return list(AXES)[: snapshot.item["dimension"]]


def draw_errors_of_force(axes, snapshot, among=True):
    """The components of E0 as points, the mean of its modulus in bins, and of its component from the centre where there
    is one, as S12 Fig. 5."""
    item, low, high = snapshot.item, snapshot.item["from"], snapshot.item["to"]
    for part in parts_of(snapshot):
        s, y = points_of(snapshot, f"E0_{part}", among)
        axes.plot(*some_of(s, y), ".", ms=4 if len(s) < 3000 else 2.5, color=AXES[part], alpha=0.5, mew=0,
                  rasterized=True, label=label_of(f"E0_{part}"))
    means = [("|E0|", "-", AXES["x"])]
    if item["abscissa"] in ("R", "r"):
        means.append((f"E0_{item['abscissa']}", "--", LINES[2]))
    for name, stroke, colour in means:
        s, y = points_of(snapshot, name, among)
        if len(s):
            axes.plot(*bin_means(s, y, low, high), stroke, lw=2.2, color=colour, label=f"mean {label_of(name)}")
    axes.set_xlim(low, high)
    axes.set_ylim(*limits_of(snapshot, "E0"))
    axes.legend(loc="upper center", ncol=3 if len(parts_of(snapshot)) == 3 else 2, columnspacing=0.9, handletextpad=0.3,
                fontsize=10, markerscale=3, borderaxespad=0.1)


def draw_panel(axes, snapshot, name, error):
    item = snapshot.item
    if name == "E0":
        draw_errors_of_force(axes, snapshot)
    else:
        draw_field(axes, snapshot, name)
    axes.set(xlabel=field_label(item, item["abscissa"]), ylabel="error $E_0$" if name == "E0" else field_label(item, name))
    axes.set_title(f"$L_1$ = {error:.3g}" if error is not None else "")


def tell_hidden_in(axes, snapshot, name):
    if name != "E0":
        tell_hidden(axes, points_of(snapshot, name)[1])


def add_legend(figure, axes, rows):
    """One for all panels, below them."""
    handles, texts = axes.get_legend_handles_labels()
    figure.legend(handles, texts, loc="lower center", bbox_to_anchor=(0.5, -0.005), ncol=len(texts), markerscale=1.8)
    figure.get_layout_engine().set(rect=(0, 0.08 / rows, 1, 1 - 0.08 / rows), w_pad=0.12)


def shared_limits(snapshots):
    """By field, the range of y that shows it in all snapshots, of which one is held at a time."""
    shared = {}
    for snapshot in snapshots:
        for name in snapshot.item["fields"]:
            if snapshot.has(name):
                low, high = limits_of(snapshot, name)
                before = shared.get(name, (low, high))
                shared[name] = min(low, before[0]), max(high, before[1])
    return shared


def draw_profiles(snapshot, errors, shared, path):
    """`errors`: the L1 norms by field name at this time, as the run recorded them; `shared`: ranges of y by field."""
    item = snapshot.item
    names = [name for name in item["fields"] if snapshot.has(name)]
    columns = 3 if len(names) != 4 else 4
    figure, panels, rows = panels_of(len(names), columns, 4.9, 4.1, header=0.9)
    for axes, name in zip(panels, names):
        draw_panel(axes, snapshot, name, errors.get(name))
        axes.set_ylim(*shared[name])
        tell_hidden_in(axes, snapshot, name)
    figure.suptitle(f"{item['title']}, {time_of(item)}", fontsize=15)
    add_legend(figure, panels[0], rows)
    save(figure, path)


def draw_one_field(snapshots, errors, name, view, path):
    """Field `name` of several runs, a panel each on one scale, as V10 Fig. 4. `errors`: the L1 norm of each, or None."""
    figure, panels, rows = panels_of(len(snapshots), 3, 5.2, 4.0, header=0.9, sharex=True)
    for axes, snapshot, error in zip(panels, snapshots, errors):
        draw_panel(axes, snapshot, name, error)
        label, title = snapshot.item["label"], axes.get_title()
        axes.set_title(f"{label}, {title}" if title else label)
    share_limits(panels)
    set_view(panels, view)
    for axes, snapshot in zip(panels, snapshots):
        tell_hidden_in(axes, snapshot, name)
    if name != "E0":
        add_legend(figure, panels[0], rows)
    save(figure, path)
