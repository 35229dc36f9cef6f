# SPDX-License-Identifier: BSD-3-Clause
"""Error against run time: four panels of a study, a line a method."""

from .style import BAND, LINES, MARKERS, NOTE, OTHERS, plain_ticks, plt, save

STROKES = ["-", "--", ":"]  # once all colours are used
MOST_LABELS = 14  # more points are labelled on the front alone


def look_of(k):
    return {"color": LINES[k % len(LINES)], "marker": MARKERS[k % len(MARKERS)], "ms": 6,
            "ls": STROKES[k // len(LINES) % len(STROKES)]}


def draw_line(axes, points, x, y, look):
    points = sorted(points, key=lambda p: p[x])
    axes.plot([p[x] for p in points], [p[y] for p in points], **look)


def draw_others(axes, others):
    """Runs of other engines in grey, a mark each engine; the legend names their machine."""
    handles = []
    for k, engine in enumerate(dict.fromkeys(o["engine"] for o in others)):
        own = [o for o in others if o["engine"] == engine]
        handles += axes.plot([o["error"] for o in own], [o["cpu"] for o in own], ls="", ms=9, mew=1.6, mfc="none",
                             color=OTHERS, marker=MARKERS[k % len(MARKERS)], label=engine)
    return handles


def draw_failures(seconds, order, failures, looks):
    """Hollow marks at the panels' worse edges: they have a cost and a resolution, but no error."""
    for failure in failures:
        look = looks[failure["method"]] | {"ls": "", "mfc": "white", "mew": 1.5, "ms": 10, "clip_on": False, "zorder": 5}
        if failure["cpu"] > 0:
            seconds.plot(0.985, failure["cpu"], transform=seconds.get_yaxis_transform(), **look)
        if order is not None and failure["n"] > 0:
            order.plot(failure["n"], 0.985, transform=order.get_xaxis_transform(), **look)
    if failures:
        (order or seconds).annotate("hollow: failed runs", (1.0, 1.01), xycoords="axes fraction", fontsize=10, ha="right",
                                    va="bottom", color=NOTE)


def draw_by_method(axes, lines, looks, key):
    """A row a method, where all have one resolution and there is no order to see."""
    for row, line in enumerate(lines):
        look = looks[line["method"]] | {"ls": ""}
        axes.plot([point[key] for point in line["points"]], [row] * len(line["points"]), **look)
    axes.set_yscale("linear")
    axes.set_yticks(range(len(lines)), [line["method"] for line in lines], fontsize=10)
    axes.set_ylim(len(lines) - 0.5, -0.5)
    axes.set(xscale="log", ylabel="")
    plain_ticks(axes.xaxis, *axes.get_xlim())


def draw_study(work):
    lines, failures, others = work["study"], work["failures"], work["others"]
    error = work["quantity"]
    figure, panels = plt.subplots(2, 2, figsize=(14, 11), constrained_layout=True)
    (seconds, order), (pairs, drift) = panels
    points = [point for line in lines for point in line["points"]]
    front = sorted((p for p in points if p["front"]), key=lambda p: p["cpu"])
    seconds.plot([p["error"] for p in front], [p["cpu"] for p in front], "-", lw=8, color=BAND, zorder=0,
                 solid_capstyle="round", label="nothing is better and cheaper")
    methods = list(dict.fromkeys([line["method"] for line in lines] + [f["method"] for f in failures]))
    looks = {method: look_of(k) for k, method in enumerate(methods)}
    several = len({p["n"] for p in points}) > 1
    for line in lines:
        look = looks[line["method"]]
        fitted = "" if line["order"] is None else f" (order {line['order']:.2f})"
        draw_line(seconds, line["points"], "error", "cpu", look | {"label": line["method"] + fitted})
        for point in line["points"]:
            if len(points) <= MOST_LABELS or point["front"]:
                seconds.annotate(f"{point['n']:g}", (point["error"], point["cpu"]), textcoords="offset points",
                                 xytext=(6, 4), fontsize=10, color=look["color"])
        draw_line(pairs, line["points"], "pairs", "error", look)
        if several:
            draw_line(order, line["points"], "n", "error", look)
            draw_line(drift, line["points"], "n", "drift", look)
    grey = draw_others(seconds, others)
    if work["target"] > 0:
        seconds.axvline(work["target"], color="black", ls=":", lw=1.2, zorder=1)
        seconds.annotate(f"target {work['target']:g}", (work["target"], 1.0), fontsize=10, ha="center", va="bottom",
                         xycoords=seconds.get_xaxis_transform())
    n = "particles along the box, $n$"
    drifts = "relative drift of the energy"
    panels = [(seconds, error, "CPU seconds"), (pairs, "pair interactions", error)]
    if several:
        panels += [(order, n, error), (drift, n, drifts)]
    for axes, x, y in panels:
        axes.set(xlabel=x, ylabel=y, xscale="log", yscale="log")
        plain_ticks(axes.xaxis, *axes.get_xlim())
        plain_ticks(axes.yaxis, *axes.get_ylim())
    draw_failures(seconds, order if several else None, failures, looks)
    if several:
        ticks = sorted({p["n"] for p in points} | {f["n"] for f in failures if f["n"] > 0})
        for axes in (order, drift):
            axes.set_xticks(ticks, [f"{n:g}" for n in ticks])
            axes.set_xlim(min(ticks) / 1.15, max(ticks) * 1.15)
            axes.minorticks_off()
    else:
        for axes, key, label in ((order, "error", error), (drift, "drift", drifts)):
            draw_by_method(axes, lines, looks, key)
            axes.set_xlabel(label)
    columns = 3 if len(lines) < 9 else 4
    rows = -(-(len(lines) + 1) // columns)
    handles, labels = seconds.get_legend_handles_labels()
    own = [k for k, label in enumerate(labels) if label not in {o["engine"] for o in others}]
    top = 0.026 * rows + (0.026 if others else 0)
    figure.get_layout_engine().set(rect=(0, 0, 1, 0.99 - top), w_pad=0.12, h_pad=0.12)
    figure.legend([handles[k] for k in own], [labels[k] for k in own], loc="upper center", ncol=columns,
                  bbox_to_anchor=(0.5, 0.965))
    if others:
        machines = "; ".join(dict.fromkeys(o["machine"] for o in others))
        figure.legend(grey, [h.get_label() for h in grey], loc="upper center", ncol=len(grey),
                      bbox_to_anchor=(0.5, 0.965 - 0.025 * rows))
        seconds.annotate(f"grey: on {machines}", (0.01, 1.0), xycoords="axes fraction", fontsize=10, va="bottom",
                         color=NOTE)
    figure.suptitle(work["title"], fontsize=15)
    save(figure, work["out"])


def draw_speed(work):
    """What an update costs beside the first method, a bar each, as S12 Fig. 11; marks: the whole run."""
    bars = work["speed"]
    figure, axes = plt.subplots(figsize=(9.5, 1.6 + 0.55 * len(bars)), constrained_layout=True)
    for row, bar in enumerate(bars):
        axes.barh(row, bar["update"], height=0.62, color=LINES[row % len(LINES)])
        axes.annotate(f"{bar['update']:.2f}", (bar["update"], row), xytext=(9, 0), textcoords="offset points",
                      va="center", fontsize=11, bbox={"fc": "white", "ec": "none", "pad": 1})
    axes.plot([bar["run"] for bar in bars], range(len(bars)), ls="", marker="D", mfc="white", mec="black", ms=7,
              label="the whole run, with its number of steps")
    axes.axvline(1, color="black", lw=1, ls=":")
    axes.set_yticks(range(len(bars)), [bar["method"] for bar in bars])
    axes.set_ylim(len(bars) - 0.4, -0.6)
    axes.set_xlim(0, 1.12 * max(max(bar["update"], bar["run"]) for bar in bars))
    axes.grid(False, axis="y")
    axes.set(xlabel=f"CPU time of an update over that of {bars[0]['method']}", title=work["title"])
    axes.legend(loc="lower left", bbox_to_anchor=(-0.02, -0.02 - 1.3 / (1 + 0.55 * len(bars))), frameon=False)
    save(figure, work["out"])
