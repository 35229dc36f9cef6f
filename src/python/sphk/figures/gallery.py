# SPDX-License-Identifier: BSD-3-Clause
"""Thumbnails of runs, a picture each, and a sheet with all of them."""

from .field_map import colours_of, draw_image, image_of
from .profiles import draw_field
from .snapshot import Snapshot
from .style import field_label, panels_of, plt, save

COLUMNS = 5


def draw_map(axes, item):
    image = image_of(item, "rho")
    draw_image(axes, image, colours_of([image]))
    axes.set(xticks=[], yticks=[])
    for side in axes.spines.values():
        side.set_visible(False)


def draw_profile(axes, snapshot, name):
    draw_field(axes, snapshot, name, point=2.5, mean=3.5, edge=1, line=1.6)
    axes.locator_params(nbins=4)
    axes.tick_params(labelsize=9)
    axes.set_xlabel(field_label(snapshot.item, snapshot.item["abscissa"]), fontsize=10, labelpad=1)
    axes.set_ylabel(field_label(snapshot.item, name), fontsize=10, labelpad=1)


def draw_tile(axes, item):
    if item["field"]:
        draw_profile(axes, Snapshot(item), item["field"])
    else:
        draw_map(axes, item)


def draw_gallery(items, path):
    for item in items:
        figure, axes = plt.subplots(figsize=(4.2, 3.4), constrained_layout=True)
        draw_tile(axes, item)
        figure.savefig(item["out"], dpi=110)
        plt.close(figure)
    figure, panels, _ = panels_of(len(items), COLUMNS, 4.3, 4.2)
    figure.get_layout_engine().set(w_pad=0.12, h_pad=0.16)
    for axes, item in zip(panels, items):
        draw_tile(axes, item)
        axes.set_title(item["heading"] + "\n" * len(item["words"]), fontsize=13, fontweight="bold", loc="left")
        axes.annotate("\n".join(item["words"]), (0, 1), xycoords="axes fraction", xytext=(0, 6),
                      textcoords="offset points", fontsize=11)
    save(figure, path)
