"""Maps of a field: the particles' values in a slice, weighted by a smoothing kernel at the centre of each pixel."""

from typing import NamedTuple

import numpy as np
from matplotlib.colors import LogNorm, Normalize
from matplotlib.ticker import FuncFormatter, LogLocator

from .snapshot import Snapshot
from .style import NEVER_NEGATIVE, WITHIN_ONE, field_label, plt, save, time_of, unit_of, with_unit

PIXELS = 320  # along the longer side
RADIUS = 3.0  # of the weighting kernel, in units of the particles' spacing
WIDE = 16  # pixels: particles that reach farther are few and are laid out one by one
FADES = 0.5, 0.2  # sums of weights, 1 inside gas, between which the picture fades out where the gas ends


def weight(q, dimension):
    """Wendland C2, times the share of its volume that a particle has: the sum over particles is 1 inside gas."""
    t = np.maximum(1 - q, 0)
    norm = 7 / np.pi if dimension == 2 else 21 / (2 * np.pi)
    return norm / RADIUS**dimension * t**4 * (1 + 4 * q)


def slice_of(snapshot, name):
    """Distance to the plane, positions in it, values and kernel radii of the particles, and of their images along a
    periodic z, that reach it: the x-y plane through the middle."""
    item = snapshot.item
    rho, value = snapshot.value("rho"), snapshot.value(name)
    radius = RADIUS * (snapshot.value("m") / rho) ** (1.0 / item["dimension"])
    known = np.isfinite(rho) & np.isfinite(value)
    x, value, radius = snapshot.x[known], value[known], radius[known]
    if item["dimension"] < 3:
        return np.zeros(len(x)), x[:, :2], value, radius
    height = item["box_size"][2]
    z = x[:, 2] - (item["box_lower"][2] + 0.5 * height)
    images = int(np.ceil(radius.max() / height)) if item["periodic"][2] else 0
    parts = []
    for shift in height * np.arange(-images, images + 1):
        near = np.abs(z + shift) < radius
        parts.append((z[near] + shift, x[near, :2], value[near], radius[near]))
    return tuple(np.concatenate(part) for part in zip(*parts))


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


class Image(NamedTuple):
    """Row 0 at the bottom; NaN and 0 where there is no gas."""

    values: np.ndarray
    opacity: np.ndarray

    def seen(self):
        return self.values[self.opacity > 0.5]


class Canvas:
    """Sums of weights and of weighted values at the centres of pixels; the picture wraps around along periodic axes."""

    def __init__(self, item, lower, size):
        self.lower, self.dimension, self.periodic = lower, item["dimension"], item["periodic"]
        self.shape = np.maximum(1, np.round(size / size.max() * PIXELS).astype(int))
        self.pixel = size / self.shape
        self.weights, self.sums = (np.zeros(self.shape[0] * self.shape[1]) for _ in range(2))

    def add(self, cell, x, z, value, radius):
        """Particles at these pixels (arrays of one length): what they weigh at the pixel's centre, images apart."""
        gap = self.lower + (cell + 0.5) * self.pixel - x
        w = weight(np.sqrt((gap**2).sum(-1) + z**2) / radius, self.dimension)
        inside = w > 0
        wrapped = cell.copy()
        for axis in range(2):
            if self.periodic[axis]:
                wrapped[..., axis] %= self.shape[axis]
            inside &= (wrapped[..., axis] >= 0) & (wrapped[..., axis] < self.shape[axis])
        index = wrapped[inside][:, 0] * self.shape[1] + wrapped[inside][:, 1]
        self.weights += np.bincount(index, weights=w[inside], minlength=len(self.weights))
        self.sums += np.bincount(index, weights=(w * value)[inside], minlength=len(self.sums))

    def image(self):
        """Gas ends in open boxes; a hole in a closed one is thin gas."""
        full, none = (0, -1) if all(self.periodic[:2]) else FADES
        opacity = np.clip((self.weights - none) / (full - none), 0, 1) * (self.weights > 0)
        with np.errstate(invalid="ignore", divide="ignore"):
            values = np.where(opacity > 0, self.sums / self.weights, np.nan)
        return Image(values.reshape(self.shape).T, opacity.reshape(self.shape).T)


def field_image(snapshot, name, lower, size):
    canvas = Canvas(snapshot.item, lower, size)
    z, x, value, radius = slice_of(snapshot, name)
    home = np.floor((x - lower) / canvas.pixel).astype(int)
    radius = np.maximum(radius, 1.5 * canvas.pixel.max())
    reach = np.ceil(radius / canvas.pixel.min()).astype(int)
    near = np.flatnonzero(reach <= WIDE)
    farthest = reach[near].max(initial=0)
    for i in range(-farthest, farthest + 1):
        for j in range(-farthest, farthest + 1):
            here = near[reach[near] >= max(abs(i), abs(j))]
            canvas.add(home[here] + (i, j), x[here], z[here], value[here], radius[here])
    for k in np.flatnonzero(reach > WIDE):
        offsets = np.arange(-min(reach[k], PIXELS), min(reach[k], PIXELS) + 1)
        cells = home[k] + np.stack(np.meshgrid(offsets, offsets, indexing="ij"), -1).reshape(-1, 2)
        canvas.add(cells, x[k], z[k], value[k], radius[k])
    return canvas.image()


def colours_of(images, name="rho", view=None):
    """One scale of colours for all images. As `view` has it; else logarithmic where quantities that are never negative
    differ by more than a factor 20, and with 0 in its middle where there are both signs."""
    view = view or {"range": None, "log": False}
    seen = np.concatenate([image.seen() for image in images])
    low, high = view["range"] or (seen.min(initial=np.inf), seen.max(initial=-np.inf))
    if not len(seen):
        low, high = view["range"] or (0.1, 1)
    automatic = view["range"] is None and not view["log"]
    if view["log"] or (automatic and name in NEVER_NEGATIVE and low > 0 and high > 20 * low):
        return {"norm": LogNorm(low, high), "cmap": "viridis"}
    if automatic:
        middle, both = 0.5 * (low + high), low < 0 < high and min(-low, high) > 0.2 * max(-low, high)
        spread = max(high - low, 1e-3 * abs(middle), 1e-300)
        low, high = middle - spread / 2, middle + spread / 2
        if both:
            low, high = -max(-low, high), max(-low, high)
        if name in WITHIN_ONE:
            low, high = 0, max(1, high)
    return {"norm": Normalize(low, high), "cmap": "RdBu_r" if low == -high else "viridis"}


def images_of(snapshots, name="rho", view=None):
    """Frames and images, and one scale of colours for all."""
    frames = [frame(snapshot) for snapshot in snapshots]
    images = [field_image(snapshot, name, *frames[k]) for k, snapshot in enumerate(snapshots)]
    return frames, images, colours_of(images, name, view)


def draw_image(axes, image, colours, lower, size):
    axes.grid(False)
    return axes.imshow(image.values, alpha=image.opacity, origin="lower", interpolation="bilinear", **colours,
                       extent=(lower[0], lower[0] + size[0], lower[1], lower[1] + size[1]))


def add_colour_bar(figure, picture, images, label, **place):
    """With arrow heads where values lie beyond the scale; plain numbers on a logarithmic one."""
    norm, seen = picture.norm, np.concatenate([image.seen() for image in images])
    rounding = 1e-9 * max(abs(norm.vmin), abs(norm.vmax))
    below, above = (seen < norm.vmin - rounding).any(), (seen > norm.vmax + rounding).any()
    extend = {(False, False): "neither", (True, False): "min", (False, True): "max", (True, True): "both"}[below, above]
    bar = figure.colorbar(picture, label=label, extend=extend, **place)
    if isinstance(norm, LogNorm):
        bar.locator = LogLocator(subs=(1, 2, 5) if norm.vmax < 1000 * norm.vmin else (1,))
        bar.formatter = FuncFormatter(lambda value, _: f"{value:g}")
        bar.minorticks_off()


def title_of(item):
    middle = item["box_lower"][2] + 0.5 * item["box_size"][2]
    where = "" if item["dimension"] < 3 else f", slice at z = {middle:.3g}{unit_of(item, 'x')}"
    return f"{item['title']}\n{time_of(item)}{where}"


def draw_maps(groups, path):
    """Panels below each other where they are wide, else side by side. A group is a field, the work orders of snapshots
    that show it, their frames, images, and one scale of colours for them."""
    shape = min(max(max(size[1] / size[0] for _, _, frames, _, _ in groups for _, size in frames), 0.25), 2.0)
    count = sum(len(items) for _, items, _, _, _ in groups)
    stacked = shape < 0.6
    rows, columns = (count, 1) if stacked else (1, count)
    figure, panels = plt.subplots(rows, columns, squeeze=False, constrained_layout=True,
                                  figsize=(7.4 * columns, (5.6 * shape + 1.5) * rows))
    panels = iter(panels.flat)
    for name, items, frames, images, colours in groups:
        own = [next(panels) for _ in items]
        for axes, item, (lower, size), image in zip(own, items, frames, images):
            picture = draw_image(axes, image, colours, lower, size)
            axes.set(xlabel=with_unit("$x$", item, "x"), ylabel=with_unit("$y$", item, "x"), title=title_of(item))
        place = {"ax": own, "pad": 0.02, "aspect": 18 * len(own)} if stacked else \
            {"cax": own[-1].inset_axes([1.03, 0, 0.045, 1])}
        add_colour_bar(figure, picture, images, field_label(items[0], name), **place)
    save(figure, path)


def draw_field_maps(snapshots, name, view, path):
    """A field of several snapshots, a panel each."""
    draw_maps([(name, [snapshot.item for snapshot in snapshots], *images_of(snapshots, name, view))], path)


def draw_frames(items, views, path_of):
    """A figure for each item, with a panel for each field of `views` that it has, on one scale for all of them; one
    snapshot is held at a time."""
    frames, images = [], []
    for item in items:
        snapshot = Snapshot(item)
        frames.append(frame(snapshot))
        images.append({name: field_image(snapshot, name, *frames[-1]) for name in views if snapshot.has(name)})
    colours = {name: colours_of([own[name] for own in images if name in own], name, views[name])
               for name in views if any(name in own for own in images)}
    for item, place, own in zip(items, frames, images):
        draw_maps([(name, [item], [place], [image], colours[name]) for name, image in own.items()], path_of(item))
