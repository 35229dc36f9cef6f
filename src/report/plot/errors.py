"""How well the particles sample their kernels, as R10 Fig. 4: a row a run with its density, the particles around the
steepest place, |E0| and P along y, and how far the nearest neighbours are."""

import numpy as np
from density_map import draw_image, images_of
from style import MEAN, PARTICLES, label_of, plt, save, share_limits, time_of, with_unit

MOST_POINTS = 30000
BINS = 64
ZOOM = 0.24  # side of the close-up, in units of the box


def in_slice(snapshot):
    """Particles within a mean spacing of the middle plane; all of them in 2D."""
    item = snapshot.item
    if item["dimension"] < 3:
        return np.ones(len(snapshot.x), dtype=bool)
    spacing = np.cbrt(snapshot.fields["m"] / snapshot.fields["rho"]).mean()
    middle = item["box_lower"][2] + 0.5 * item["box_size"][2]
    return np.abs(snapshot.x[:, 2] - middle) < 0.75 * spacing


def steepest_place(image, lower, size):
    """Where the density changes most: the centre of the close-up."""
    slope = np.hypot(*np.gradient(np.log(np.maximum(np.nan_to_num(image, nan=1e-300), 1e-300))))
    rows = slope.shape[0]
    slope[: rows // 2] = 0  # of two interfaces, the upper one
    row, column = np.unravel_index(np.argmax(slope), slope.shape)
    return lower + (np.array([column, row]) + 0.5) / np.array(image.T.shape) * size


def draw_close_up(axes, snapshot, centre, side):
    lower, size = (np.array(snapshot.item[key][:2]) for key in ("box_lower", "box_size"))
    centre = np.clip(centre, lower + side / 2, lower + size - side / 2)
    here = in_slice(snapshot)
    x, colour = snapshot.x[here], np.log(snapshot.fields["rho"][here])
    near = (np.abs(x[:, :2] - centre) < side / 2).all(1)
    size = np.clip(40000 / max(near.sum(), 1), 3, 60)
    axes.scatter(x[near, 0], x[near, 1], s=size, c=colour[near], cmap="viridis", vmin=colour.min(), vmax=colour.max(), lw=0)
    axes.set(xlim=(centre[0] - side / 2, centre[0] + side / 2), ylim=(centre[1] - side / 2, centre[1] + side / 2))
    axes.set_aspect("equal")
    axes.grid(False)
    axes.set_title("particles where the density is steepest")


def draw_along_y(axes, snapshot, value, label, logarithmic):
    """Particles of the slice as points, and the mean in bins of y."""
    here = in_slice(snapshot)
    y, value = snapshot.x[here, 1], value[here]
    low, size = snapshot.item["box_lower"][1], snapshot.item["box_size"][1]
    shown = np.random.default_rng(1).permutation(len(y))[:MOST_POINTS]
    axes.plot(y[shown], value[shown], ".", ms=2.5, color=PARTICLES, mew=0, rasterized=True)
    index = np.clip(((y - low) / size * BINS).astype(int), 0, BINS - 1)
    count = np.bincount(index, minlength=BINS)
    mean = np.bincount(index, weights=value, minlength=BINS)[count > 0] / count[count > 0]
    axes.plot(low + (np.flatnonzero(count) + 0.5) / BINS * size, mean, "-", color=MEAN, lw=1.6)
    if logarithmic:
        axes.set_yscale("log")
    axes.set(xlim=(low, low + size), ylabel=label)


def draw_nearest(axes, snapshot):
    """Distances of nearest neighbours in mean spacings: particles that clump fill the left."""
    spacing = (snapshot.fields["m"] / snapshot.fields["rho"]) ** (1 / snapshot.item["dimension"])
    known = snapshot.nearest > 0
    axes.hist(snapshot.nearest[known] / spacing[known], bins=np.linspace(0, 1.5, 61), density=True, color=PARTICLES,
              ec=MEAN, lw=0.5)
    axes.set(xlim=(0, 1.5), ylabel="share of particles, per spacing")


def draw_errors(snapshots, path):
    frames, images, norm = images_of(snapshots)
    figure, grid = plt.subplots(len(snapshots), 5, squeeze=False, figsize=(26, 4.7 * len(snapshots)),
                                constrained_layout=True)
    for row, snapshot, (lower, size), image in zip(grid, snapshots, frames, images):
        item = snapshot.item
        picture = draw_image(row[0], image, norm, lower, size)
        row[0].set(title=f"{item['title']}\n{time_of(item)}", ylabel=with_unit("$y$", item, "x"))
        figure.colorbar(picture, ax=row[0], label=label_of(item, "rho"))
        draw_close_up(row[1], snapshot, steepest_place(image, lower, size), ZOOM * size.max())
        draw_along_y(row[2], snapshot, np.sqrt((snapshot.E0**2).sum(1)), r"$|E_0|$", True)
        draw_along_y(row[3], snapshot, snapshot.fields["P"], label_of(item, "P"), False)
        draw_nearest(row[4], snapshot)
    share_limits(grid[:, 2], decades=6)
    share_limits(grid[:, 3])
    labels = ("$x$", "$x$", "$y$", "$y$", "distance of the nearest neighbour")
    for axes, label in zip(grid[-1], labels):
        axes.set_xlabel(label if label.startswith("distance") else with_unit(label, snapshots[-1].item, "x"))
    save(figure, path)
