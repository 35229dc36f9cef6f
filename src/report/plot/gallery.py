"""Thumbnails of runs, a picture each, and a sheet with all of them."""

import numpy as np
from density_map import colour_norm, density_image, frame
from profiles import MOST_POINTS, bin_means, field_label, limits
from snapshot import Snapshot
from style import EXACT, LABELS, MEAN, PARTICLES, plt, save

COLUMNS = 5


def draw_map(axes, snapshot):
    lower, size = frame(snapshot)
    image = density_image(snapshot, lower, size)
    axes.imshow(image, origin="lower", norm=colour_norm([image]), cmap="viridis", interpolation="bilinear",
                extent=(lower[0], lower[0] + size[0], lower[1], lower[1] + size[1]))
    axes.set(xticks=[], yticks=[])
    axes.grid(False)
    for side in axes.spines.values():
        side.set_visible(False)


def draw_profile(axes, snapshot, name):
    item, low, high = snapshot.item, snapshot.item["from"], snapshot.item["to"]
    s, y = snapshot.abscissa(), snapshot.value(name)
    inside = (s >= low) & (s < high)
    s, y = s[inside], y[inside]
    shown = np.random.default_rng(1).permutation(len(s))[:MOST_POINTS]
    axes.plot(s[shown], y[shown], ".", ms=2.5, color=PARTICLES, mew=0, rasterized=True)
    axes.plot(*bin_means(s, y, low, high), "o", ms=3.5, mfc="white", mec=MEAN, mew=1)
    heights = list(y)
    if item["exact"] and name in item["exact"]:
        axes.plot(item["exact"]["abscissa"], item["exact"][name], "-", lw=1.6, color=EXACT)
        heights += item["exact"][name]
    axes.set_ylim(*limits(heights))
    axes.set_xlim(low, high)
    axes.locator_params(nbins=4)
    axes.tick_params(labelsize=9)
    axes.set_xlabel(LABELS[item["abscissa"]], fontsize=10, labelpad=1)
    axes.set_ylabel(field_label(item, name), fontsize=10, labelpad=1)


def draw_tile(axes, item):
    snapshot = Snapshot(item)
    if item["field"]:
        draw_profile(axes, snapshot, item["field"])
    else:
        draw_map(axes, snapshot)


def draw_gallery(items, path):
    for item in items:
        figure, axes = plt.subplots(figsize=(4.2, 3.4), constrained_layout=True)
        draw_tile(axes, item)
        figure.savefig(item["out"], dpi=110)
        plt.close(figure)
    columns = min(COLUMNS, len(items))
    rows = -(-len(items) // columns)
    figure, grid = plt.subplots(rows, columns, figsize=(4.3 * columns, 4.2 * rows), squeeze=False,
                                constrained_layout=True)
    figure.get_layout_engine().set(w_pad=0.12, h_pad=0.16)
    for axes, item in zip(grid.flat, items):
        draw_tile(axes, item)
        axes.set_title(item["heading"] + "\n" * len(item["words"]), fontsize=13, fontweight="bold", loc="left")
        axes.annotate("\n".join(item["words"]), (0, 1), xycoords="axes fraction", xytext=(0, 6),
                      textcoords="offset points", fontsize=11)
    for axes in list(grid.flat)[len(items):]:
        axes.axis("off")
    save(figure, path)
