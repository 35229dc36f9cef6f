"""Error against run time: four panels of a study, a line a method."""

import numpy as np
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter
from style import LINES, MARKERS, plt, save


def pareto(points):
    """Points by rising cost that have a smaller error than all cheaper ones."""
    front, best = [], np.inf
    for point in sorted(points, key=lambda p: (p["cpu"], p["error"])):
        if point["error"] < best:
            best = point["error"]
            front.append(point)
    return front


def draw_line(axes, points, x, y, look):
    points = sorted(points, key=lambda p: p[x])
    axes.plot([p[x] for p in points], [p[y] for p in points], **look)


def plain_ticks(axis, low, high):
    """Numbers as they are read, 1, 2 and 5 of a decade where there are few decades."""
    few = np.log10(max(high / max(low, 1e-300), 1)) < 2.5
    axis.set_major_locator(LogLocator(subs=(1, 2, 5) if few else (1,)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:.3g}"))
    axis.set_minor_formatter(NullFormatter())


def draw_study(work):
    lines, error = work["study"], f"$L_1$ error of {work['norm']}"
    figure, panels = plt.subplots(2, 2, figsize=(14, 10.5), constrained_layout=True)
    (seconds, order), (pairs, drift) = panels
    front = pareto([point for line in lines for point in line["points"]])
    seconds.plot([p["error"] for p in front], [p["cpu"] for p in front], "-", lw=7, color="#dddddd", zorder=0,
                 label="nothing is better and cheaper")
    for k, line in enumerate(lines):
        look = {"color": LINES[k % len(LINES)], "marker": MARKERS[k % len(MARKERS)], "ms": 6, "label": line["method"]}
        draw_line(seconds, line["points"], "error", "cpu", look)
        for point in line["points"]:
            seconds.annotate(f"{point['n']:g}", (point["error"], point["cpu"]), textcoords="offset points",
                             xytext=(6, 4), fontsize=9, color=look["color"])
        fitted = "" if line["order"] is None else f", order {line['order']:.2f}"
        draw_line(order, line["points"], "n", "error", look | {"label": line["method"] + fitted})
        draw_line(pairs, line["points"], "pairs", "error", look)
        draw_line(drift, line["points"], "n", "drift", look)
    if work["target"] > 0:
        seconds.axvline(work["target"], color="black", ls=":", lw=1.2)
    for axes, x, y in ((seconds, error, "CPU seconds"), (order, "particles along the box, n", error),
                       (pairs, "pair interactions", error), (drift, "particles along the box, n", "drift of energy")):
        axes.set(xlabel=x, ylabel=y, xscale="log", yscale="log")
        plain_ticks(axes.xaxis, *axes.get_xlim())
        plain_ticks(axes.yaxis, *axes.get_ylim())
    seconds.legend()
    order.legend()
    figure.suptitle(work["title"], fontsize=15)
    save(figure, work["out"])
