"""A slice through the density: the particles' values, weighted by a smoothing kernel at the centre of each pixel."""

import numpy as np
from matplotlib.colors import LogNorm, Normalize
from matplotlib.ticker import FuncFormatter, LogLocator
from mpl_toolkits.axes_grid1 import make_axes_locatable
from style import label_of, plt, save, time_of, unit_of, with_unit

PIXELS = 320  # along the longer side
RADIUS = 2.0  # of the weighting kernel, in units of the particles' spacing


def weight(q):
    """Wendland C2 up to its norm, which the division by the sum of weights removes."""
    t = np.maximum(1 - q, 0)
    return t**4 * (1 + 4 * q)


def slice_of(snapshot):
    """Distance to the plane, positions in it, values and kernel radii of the particles that reach it (x-y plane)."""
    item = snapshot.item
    rho, mass = snapshot.fields["rho"], snapshot.fields["m"]
    radius = RADIUS * (mass / rho) ** (1.0 / item["dimension"])
    flat = item["dimension"] < 3
    z = np.zeros(len(rho)) if flat else snapshot.x[:, 2] - (item["box_lower"][2] + 0.5 * item["box_size"][2])
    near = np.isfinite(rho) & (np.abs(z) < radius)
    return z[near], snapshot.x[near, :2], rho[near], radius[near]


def frame(snapshot):
    """Lower corner and size of the picture: the box along periodic axes, the extent of the gas along open ones."""
    item = snapshot.item
    lower, size = np.array(item["box_lower"][:2]), np.array(item["box_size"][:2])
    for axis in range(2):
        if not item["periodic"][axis]:
            low, high = snapshot.x[:, axis].min(), snapshot.x[:, axis].max()
            margin = 0.04 * max(high - low, 1e-6 * size[axis])
            lower[axis], size[axis] = low - margin, high - low + 2 * margin
    return lower, size


def density_image(snapshot, lower, size):
    """The image, row 0 at the bottom; pixels that no particle reaches are NaN."""
    z, x, rho, radius = slice_of(snapshot)
    pixel = size.max() / PIXELS
    shape = np.maximum(1, np.round(size / pixel).astype(int))
    sums, weights = np.zeros(shape[0] * shape[1]), np.zeros(shape[0] * shape[1])
    home = np.floor((x - lower) / pixel).astype(int)
    radius = np.maximum(radius, 1.5 * pixel)
    reach = np.ceil(radius / pixel).astype(int)
    for i in range(-reach.max(), reach.max() + 1):
        for j in range(-reach.max(), reach.max() + 1):
            near = reach >= max(abs(i), abs(j))
            cell = home[near] + (i, j)
            gap = lower + (cell + 0.5) * pixel - x[near]
            w = weight(np.sqrt((gap**2).sum(1) + z[near] ** 2) / radius[near])
            inside = ((cell >= 0) & (cell < shape)).all(1)
            index = cell[inside, 0] * shape[1] + cell[inside, 1]
            weights += np.bincount(index, weights=w[inside], minlength=len(weights))
            sums += np.bincount(index, weights=(w * rho[near])[inside], minlength=len(sums))
    with np.errstate(invalid="ignore", divide="ignore"):
        return (sums / weights).reshape(shape).T


def colour_norm(images):
    """One scale for all images, logarithmic where the densities differ by more than a factor 20."""
    low, high = min(np.nanmin(image) for image in images), max(np.nanmax(image) for image in images)
    if low > 0 and high > 20 * low:
        return LogNorm(low, high)
    middle = 0.5 * (low + high)
    spread = max(high - low, 1e-3 * abs(middle))
    return Normalize(middle - spread / 2, middle + spread / 2)


def images_of(snapshots):
    """Frames and images, and one colour scale for all."""
    frames = [frame(snapshot) for snapshot in snapshots]
    images = [density_image(snapshot, *frames[k]) for k, snapshot in enumerate(snapshots)]
    return frames, images, colour_norm(images)


def draw_image(axes, image, norm, lower, size):
    axes.grid(False)
    return axes.imshow(image, origin="lower", norm=norm, cmap="viridis", interpolation="bilinear",
                       extent=(lower[0], lower[0] + size[0], lower[1], lower[1] + size[1]))


def draw_density_maps(snapshots, path):
    """A panel for each snapshot, on one colour scale: wide ones below each other, others side by side."""
    frames, images, norm = images_of(snapshots)
    shape = min(max(max(size[1] / size[0] for _, size in frames), 0.25), 2.0)
    rows, columns = (len(images), 1) if shape < 0.6 else (1, len(images))
    figure, panels = plt.subplots(rows, columns, squeeze=False, constrained_layout=True,
                                  figsize=(7.4 * columns, (5.6 * shape + 1.5) * rows))
    figure.get_layout_engine().set(wspace=0.15)  # it does not see the colour bars' labels
    for axes, snapshot, (lower, size), image in zip(panels.flat, snapshots, frames, images):
        item = snapshot.item
        picture = draw_image(axes, image, norm, lower, size)
        middle = item["box_lower"][2] + 0.5 * item["box_size"][2]
        where = "" if item["dimension"] < 3 else f", slice at z = {middle:.3g}{unit_of(item, 'x')}"
        axes.set(xlabel=with_unit("$x$", item, "x"), ylabel=with_unit("$y$", item, "x"),
                 title=f"{item['title']}\n{time_of(item)}{where}")
        bar = make_axes_locatable(axes).append_axes("right", size=0.22, pad=0.15)
        colours = figure.colorbar(picture, cax=bar, label=label_of(item, "rho"))
        if isinstance(norm, LogNorm):
            colours.locator = LogLocator(subs=(1, 2, 5))
            colours.formatter = FuncFormatter(lambda value, _: f"{value:g}")
            colours.minorticks_off()
    save(figure, path)
