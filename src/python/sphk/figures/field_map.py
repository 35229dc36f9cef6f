# SPDX-License-Identifier: BSD-3-Clause
"""Maps of a field: pictures that the command line projects, on scales of colours that several of them share."""

from typing import NamedTuple

import matplotlib
import numpy as np
from matplotlib.colors import LogNorm, Normalize
from matplotlib.ticker import FuncFormatter, LogLocator

from .style import (DIVERGING, NEVER_NEGATIVE, SEQUENTIAL, VANISHING, WITHIN_ONE, field_label, plt, save, time_of,
                    unit_of, with_unit)

FADES = 0.7, 0.1  # shares of a pixel that is gas, between which the picture fades out where the gas ends
INSIDE = 0.9  # of a pixel is gas: not its border, where densities fall
THIN = 1e-3  # part of the largest integral along z below which there is as good as no gas


class Image(NamedTuple):
    """Row 0 at the bottom; NaN where there is no gas and nothing to show."""

    values: np.ndarray
    opacity: np.ndarray
    window: tuple  # x0, x1, y0, y1
    gas: np.ndarray  # where there is gas: what is seen there sets the scale
    vacuum: bool  # the field falls to 0 where gas ends: scales begin with 0, whose colour is that of the background

    def seen(self):
        return self.values[self.gas & np.isfinite(self.values)]


def array_of(numbers):
    return np.load(numbers) if isinstance(numbers, str) else np.asarray(numbers)


def image_of(item, name):
    """The picture of a field in a work order: arrays, or files with them. Where gas ends in an open box, what vanishes
    with it falls to 0, and what has no meaning without gas fades."""
    work = item["images"][name]
    values, window = array_of(work["values"]), work["window"]
    opaque = np.ones(values.shape)
    if work["column"]:
        thin = name in NEVER_NEGATIVE and values.min() < THIN * values.max()
        return Image(values, opaque, window, (values > THIN * values.max()) if thin else opaque > 0, thin)
    if work["cover"] is None:
        return Image(values, np.isfinite(values).astype(float), window, np.isfinite(values), False)
    cover = np.clip(array_of(work["cover"]), 0, 1)
    if name in VANISHING:
        return Image(np.nan_to_num(values) * np.minimum(cover / INSIDE, 1), opaque, window, cover > INSIDE, True)
    full, none = FADES
    part = np.clip((cover - none) / (full - none), 0, 1)
    return Image(values, np.where(np.isfinite(values), part * part * (3 - 2 * part), 0), window, cover > 0.5, False)


def range_of(images):
    """The least and largest value seen where there is gas, or nothing."""
    extremes = [(seen.min(), seen.max()) for seen in (image.seen() for image in images) if len(seen)]
    return (min(low for low, _ in extremes), max(high for _, high in extremes)) if extremes else None


def colours_of(images, name="rho", view=None):
    """One scale of colours for all images."""
    return scale_of(range_of(images), name, view, any(image.vacuum for image in images))


def scale_of(seen, name="rho", view=None, vacuum=False):
    """A scale of colours for values of that range. As `view` has it; else logarithmic where quantities that are never
    negative differ by more than a factor 20, and with 0 in its middle where there are both signs."""
    view = view or {"range": None, "log": False}
    low, high = view["range"] or seen or (0.1, 1)
    automatic = view["range"] is None and not view["log"]
    if view["log"] or (automatic and name in NEVER_NEGATIVE and low > 0 and high > 20 * low):
        return {"norm": LogNorm(low, high), "cmap": SEQUENTIAL}
    if automatic:
        if vacuum:
            low = min(low, 0)
        middle, both = 0.5 * (low + high), low < 0 < high and min(-low, high) > 0.2 * max(-low, high)
        spread = max(high - low, 1e-3 * abs(middle), 1e-300)
        low, high = middle - spread / 2, middle + spread / 2
        if both:
            low, high = -max(-low, high), max(-low, high)
        if name in WITHIN_ONE:
            low, high = 0, max(1, high)
    return {"norm": Normalize(low, high), "cmap": DIVERGING if low == -high else SEQUENTIAL}


def draw_image(axes, image, colours):
    axes.grid(False)
    if image.vacuum:
        axes.set_facecolor(matplotlib.colormaps[colours["cmap"]](0.0))  # of what a logarithmic scale has no colour for
    return axes.imshow(image.values, alpha=image.opacity, origin="lower", interpolation="bilinear", **colours,
                       extent=image.window)


def add_colour_bar(figure, picture, seen, label, **place):
    """With arrow heads where values lie beyond the scale; plain numbers on a logarithmic one."""
    norm, (low, high) = picture.norm, seen or (picture.norm.vmin, picture.norm.vmax)
    rounding = 1e-6 * max(abs(norm.vmin), abs(norm.vmax))
    below, above = low < norm.vmin - rounding, high > norm.vmax + rounding
    extend = {(False, False): "neither", (True, False): "min", (False, True): "max", (True, True): "both"}[below, above]
    bar = figure.colorbar(picture, label=label, extend=extend, **place)
    if isinstance(norm, LogNorm):
        bar.locator = LogLocator(subs=(1, 2, 5) if norm.vmax < 1000 * norm.vmin else (1,))
        bar.formatter = FuncFormatter(lambda value, _: f"{value:g}")
        bar.minorticks_off()


def map_label(item, name):
    """What the colours of a map mean."""
    if not item["images"][name]["column"]:
        return field_label(item, name)
    return f"{field_label(item, name)}, integral along $z${unit_of(item, 'x')}"


def title_of(item, name):
    work = item["images"][name]
    where = "" if work["z"] is None else f", slice at z = {work['z']:.3g}{unit_of(item, 'x')}"
    return f"{item['title']}\n{time_of(item)}{where}"


def shape_of(images):
    """Height over width of panels for these images."""
    heights = [(y1 - y0) / (x1 - x0) for x0, x1, y0, y1 in (image.window for image in images)]
    return min(max(max(heights), 0.25), 2.0)


def map_panels(shape, count):
    """A figure of panels below each other where they are wide, else side by side, and whether they are stacked."""
    stacked = shape < 0.6
    rows, columns = (count, 1) if stacked else (1, count)
    figure, panels = plt.subplots(rows, columns, squeeze=False, constrained_layout=True,
                                  figsize=(7.4 * columns, (5.6 * shape + 1.5) * rows))
    return figure, list(panels.flat), stacked


def draw_panels(figure, panels, stacked, name, items, images, colours, seen):
    """A field of several snapshots on the panels, with one bar of colours for them; returns the pictures."""
    pictures = []
    for axes, item, image in zip(panels, items, images):
        pictures.append(draw_image(axes, image, colours))
        axes.set(xlabel=with_unit("$x$", item, "x"), ylabel=with_unit("$y$", item, "x"), title=title_of(item, name))
    place = {"ax": panels, "pad": 0.02, "aspect": 18 * len(panels)} if stacked else \
        {"cax": panels[-1].inset_axes([1.03, 0, 0.045, 1])}
    add_colour_bar(figure, pictures[-1], seen, map_label(items[0], name), **place)
    return pictures


def draw_field_maps(items, name, view, path):
    """A field of several snapshots, a panel each, on one scale."""
    images = [image_of(item, name) for item in items]
    figure, panels, stacked = map_panels(shape_of(images), len(items))
    draw_panels(figure, panels, stacked, name, items, images, colours_of(images, name, view), range_of(images))
    save(figure, path)


def common_scale(frames, name, view):
    """One scale for the pictures of many items, of which one is held at a time, and the values that they have."""
    seen, vacuum = None, False
    for item in frames:
        image = image_of(item, name)
        ends = [end for end in (seen, range_of([image])) if end]
        seen = (min(low for low, _ in ends), max(high for _, high in ends)) if ends else None
        vacuum = vacuum or image.vacuum
    return scale_of(seen, name, view, vacuum), seen


def draw_frames(items, views):
    """A figure for each item, with a panel for each field of `views` that it has, on one scale for all of them."""
    names = dict.fromkeys(name for item in items for name in item["images"])
    scales = {name: common_scale([item for item in items if name in item["images"]], name, views.get(name))
              for name in names}
    for item in items:
        images = {name: image_of(item, name) for name in item["images"]}
        figure, panels, stacked = map_panels(shape_of(images.values()), len(images))
        for axes, (name, image) in zip(panels, images.items()):
            draw_panels(figure, [axes], stacked, name, [item], [image], *scales[name])
        save(figure, item["map_out"])
