"""Figures 6.13 to 6.15."""

import matplotlib.pyplot as plt
import numpy as np

from data import feet, group
from pictures import draw_match
from published import EQUAL_TO_UNEQUAL, EQUAL_WEIGHTS, UNEQUAL_WEIGHTS
from style import METHODS, NAMES, legend_below, save


def draw_one_place(tables, out):
    poses, readings = group(tables.rows("weights-poses"), "figure"), group(tables.rows("weights-readings"), "figure")
    figure, axes = plt.subplots(1, 2, figsize=(11, 6.2))
    errors = []
    for panel, name, title in zip(axes, ("6.13", "6.14"), ("equal weights", "walls count twice")):
        places = {row["kind"]: row for row in poses[name]}
        off = np.hypot(*(feet([places["true"]], axis)[0] - feet([places["best"]], axis)[0] for axis in ("x_m", "y_m")))
        errors.append(off)
        draw_match(panel, tables.room("sample-room", "sample"), poses[name], readings[name])
        panel.set_title(f"Figure {name}: {title}, {off:.2f} ft off")
    legend_below(figure, axes[0], 6)
    return save(figure, out, "weights-match", "One place matched with equal and with unequal weights"), errors


def draw_sweep(groups, out):
    figure, axes = plt.subplots(figsize=(7.2, 3.8))
    for method in ("thesis as printed", "thesis"):
        weights = sorted({float(key[1]) for key in groups if key[0] == method})
        means = [np.mean(feet(groups[method, f"{w:g}"])) for w in weights]
        medians = [np.median(feet(groups[method, f"{w:g}"])) for w in weights]
        axes.plot(weights, means, marker="o", ms=4, **METHODS[method])
        axes.plot(weights, medians, ls="--", lw=1.1, color=METHODS[method]["color"])
    axes.axvline(2.0, color="#888888", ls=":", lw=1)
    axes.set_ylim(bottom=0)
    axes.set_xlabel("weight of a wall, a corner counting 1 (dotted: the thesis's choice)")
    axes.set_ylabel("location error, ft (dashed: median)")
    axes.set_title("Figure 6.15: effect of the weights, all checkpoints")
    axes.legend()
    return save(figure, out, "weights", "Location error against the weight of walls")


def section(tables, out):
    groups = group(tables.rows("weights"), "method", "weight")
    place, (equal_here, unequal_here) = draw_one_place(tables, out)
    sweep = draw_sweep(groups, out)
    equal, unequal = (np.mean(feet(groups["thesis as printed", w])) for w in ("1", "2"))
    other = [np.mean(feet(groups["thesis", w])) for w in ("1", "2")]
    text = f"""
## Walls against corners (figures 6.13 to 6.15)

{place}

The checkpoint of the circular walk at which equal weights lose most: {equal_here:.2f} ft against {unequal_here:.2f} ft. The
thesis's own such checkpoint: {EQUAL_WEIGHTS} ft against {UNEQUAL_WEIGHTS} ft.

{sweep}

Over all checkpoints of all walks (furnished) equal weights cost {100 * (equal / unequal - 1):.0f} % with (5.1) as printed
({equal:.2f} against {unequal:.2f} ft) and {100 * (other[0] / other[1] - 1):.0f} % with `--method thesis`. The thesis reports a
factor of nearly six, at two checkpoints "chosen because the effect of the weighting system is significant at these locations". The
direction holds, and so does "twice or more": nothing is lost by more. The size at chosen places is not the size on average.
The tracker has no such weights: how often each kind of element answers, and how far its readings scatter, is in its likelihood.
"""
    return text, [("Equal weights are worse than 2:1", f"{EQUAL_TO_UNEQUAL:.0f} times the error at two checkpoints",
                   f"{equal:.2f} ft against {unequal:.2f} ft over all checkpoints", equal > unequal)]
