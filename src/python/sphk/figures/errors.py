# SPDX-License-Identifier: BSD-3-Clause
"""How well the particles sample their kernels, as R10 Fig. 4: a row a run with its density, the particles around the
steepest place, |E0|, its components (S12 Fig. 5) and P along the scene's own coordinate, and how far the nearest
neighbours are."""

import numpy as np

from .field_map import add_colour_bar, colours_of, draw_image, image_of, range_of
from .profiles import bin_means, draw_errors_of_force, points_of, some_of
from .style import MEAN, PARTICLES, SEQUENTIAL, field_label, plt, save, share_limits, time_of, with_unit

ZOOM = 0.24  # side of the close-up, in units of the box


def in_slice(snapshot):
    """Particles within a mean spacing of the middle plane; all of them in 2D."""
    item = snapshot.item
    if item["dimension"] < 3:
        return np.ones(len(snapshot.x), dtype=bool)
    spacing = np.cbrt(snapshot.value("m") / snapshot.value("rho")).mean()
    return np.abs(snapshot.x[:, 2] - item["images"]["rho"]["z"]) < 0.75 * spacing


def along_abscissa(snapshot):
    """Particles that are drawn along the scene's coordinate: of the slice, unless it is spherical."""
    return True if snapshot.item["abscissa"] == "r" else in_slice(snapshot)


def corners(image):
    """Lower corner and size."""
    x0, x1, y0, y1 = image.window
    return np.array([x0, y0]), np.array([x1 - x0, y1 - y0])


def steepest_place(image):
    """Where the density changes most inside the gas: the centre of the close-up."""
    lower, size = corners(image)
    slope = np.nan_to_num(np.hypot(*np.gradient(np.log(image.values))))
    rows = slope.shape[0]
    slope[: rows // 2] = 0  # of two interfaces, the upper one
    row, column = np.unravel_index(np.argmax(slope), slope.shape)
    return lower + (np.array([column, row]) + 0.5) / np.array(image.values.T.shape) * size


def draw_close_up(axes, snapshot, image, centre):
    lower, size = corners(image)
    side = ZOOM * size.max()
    centre = np.clip(centre, lower + side / 2, lower + size - side / 2)
    here = in_slice(snapshot)
    x, colour = snapshot.x[here], np.log(snapshot.value("rho")[here])
    near = (np.abs(x[:, :2] - centre) < side / 2).all(1)
    size = np.clip(40000 / max(near.sum(), 1), 3, 60)
    axes.scatter(x[near, 0], x[near, 1], s=size, c=colour[near], cmap=SEQUENTIAL, vmin=colour.min(), vmax=colour.max(), lw=0)
    axes.set(xlim=(centre[0] - side / 2, centre[0] + side / 2), ylim=(centre[1] - side / 2, centre[1] + side / 2))
    axes.set_aspect("equal")
    axes.grid(False)
    axes.set_title("particles where the density is steepest")


def draw_along(axes, snapshot, name, logarithmic):
    """Particles as points along the scene's coordinate, and their mean in bins."""
    item = snapshot.item
    s, value = points_of(snapshot, name, along_abscissa(snapshot))
    axes.plot(*some_of(s, value), ".", ms=2.5, color=PARTICLES, mew=0, rasterized=True)
    axes.plot(*bin_means(s, value, item["from"], item["to"]), "-", color=MEAN, lw=1.6)
    if logarithmic:
        axes.set_yscale("log")
    axes.set(xlim=(item["from"], item["to"]), xlabel=field_label(item, item["abscissa"]), ylabel=field_label(item, name))


def draw_components(axes, snapshot):
    draw_errors_of_force(axes, snapshot, along_abscissa(snapshot))
    axes.set(xlabel=field_label(snapshot.item, snapshot.item["abscissa"]), ylabel="components of $E_0$")


def draw_nearest(axes, snapshot):
    """Distances of nearest neighbours in mean spacings: particles that clump fill the left."""
    spacing = (snapshot.value("m") / snapshot.value("rho")) ** (1 / snapshot.item["dimension"])
    nearest = snapshot.value("NearestNeighbour")
    known = nearest > 0
    axes.hist(nearest[known] / spacing[known], bins=np.linspace(0, 1.5, 61), density=True, color=PARTICLES, ec=MEAN,
              lw=0.5)
    axes.set(xlim=(0, 1.5), xlabel="distance of the nearest neighbour in spacings",
             ylabel="share of particles, per spacing")


def draw_errors(snapshots, path):
    images = [image_of(snapshot.item, "rho") for snapshot in snapshots]
    colours = colours_of(images)
    figure, grid = plt.subplots(len(snapshots), 6, squeeze=False, figsize=(31, 4.7 * len(snapshots)),
                                constrained_layout=True)
    for row, snapshot, image in zip(grid, snapshots, images):
        item = snapshot.item
        picture = draw_image(row[0], image, colours)
        row[0].set(title=f"{item['title']}\n{time_of(item)}", xlabel=with_unit("$x$", item, "x"),
                   ylabel=with_unit("$y$", item, "x"))
        draw_close_up(row[1], snapshot, image, steepest_place(image))
        draw_along(row[2], snapshot, "|E0|", True)
        draw_components(row[3], snapshot)
        draw_along(row[4], snapshot, "P", False)
        draw_nearest(row[5], snapshot)
    add_colour_bar(figure, picture, range_of(images), field_label(item, "rho"), ax=list(grid[:, 0]), aspect=20 * len(snapshots))
    share_limits(grid[:, 2], decades=6)
    share_limits(grid[:, 3])
    share_limits(grid[:, 4])
    save(figure, path)
