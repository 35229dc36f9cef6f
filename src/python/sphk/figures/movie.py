# SPDX-License-Identifier: BSD-3-Clause
"""Films: maps of runs side by side, on one scale of colours and with one layout for all pictures."""

import os

import matplotlib
from matplotlib import animation

from .field_map import common_scale, draw_panels, image_of, map_panels, shape_of, title_of
from .style import plt, tell

DPI = 110
LIMIT = 2000  # MB that a page may hold
H264 = ["-pix_fmt", "yuv420p", "-crf", "18", "-preset", "veryfast", "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white"]


def writer_for(path, fps):
    ending = os.path.splitext(path)[1]
    if ending == ".gif":
        return animation.PillowWriter(fps=fps)
    if ending == ".html":
        matplotlib.rcParams["animation.embed_limit"] = LIMIT
        return animation.HTMLWriter(fps=fps, embed_frames=True, default_mode="loop")
    return animation.FFMpegWriter(fps=fps, extra_args=H264)


def draw_movie(work):
    frames, name = work["movie"], work["field"]
    colours, seen = common_scale([item for frame in frames for item in frame], name, work["view"])
    images = [image_of(item, name) for item in frames[0]]
    figure, panels, stacked = map_panels(shape_of(images), len(images))
    pictures = draw_panels(figure, panels, stacked, name, frames[0], images, colours, seen)
    figure.canvas.draw()
    figure.set_layout_engine("none")  # as it is now
    writer = writer_for(work["out"], work["fps"])
    with writer.saving(figure, work["out"], DPI):
        for frame in frames:
            for axes, picture, item in zip(panels, pictures, frame):
                image = image_of(item, name)
                picture.set_data(image.values)
                picture.set_alpha(image.opacity)
                axes.set_title(title_of(item, name))
            writer.grab_frame()
    plt.close(figure)
    tell(work["out"])
