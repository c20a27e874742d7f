"""Figures 6.25 and 6.26."""

import matplotlib.pyplot as plt
import numpy as np

from data import feet, group, numbers
from pictures import draw_numbers, draw_room, draw_wearer, points
from style import FEET, METHODS, NAMES, save, table

POSE = (17.5, 12.0, 0.0)
SETTLE = 20.0
PARTS = {"lights off, standing": (0.0, SETTLE), "lights on, standing": (SETTLE, 2 * SETTLE), "lights on, walking": (2 * SETTLE, 1e9)}


def disturbed(row):
    """Whether a sensor reads short with the lights on, or hears something where nothing answers."""
    on, off = float(row["on_m"]), float(row["off_m"])
    return on >= 0 and (off < 0 or on < off - 0.15)


def draw(tables, groups, out):
    scans = tables.rows("lights-scans")
    figure, axes = plt.subplots(1, 3, figsize=(14, 4.8), width_ratios=[1, 1, 1.5])
    for panel, column, title in ((axes[0], "on_m", "Figure 6.25: lights on"), (axes[1], "off_m", "Figure 6.26: lights off")):
        draw_room(panel, tables.room("torgersen-lab", "5"))
        for x, y, row in points(POSE, scans, column):
            colour = "#d55e00" if disturbed(row) and column == "on_m" else "#0072b2"
            panel.plot([POSE[0], x], [POSE[1], y], color="#dddddd", lw=0.8, zorder=1)
            panel.plot(x, y, "D", color=colour, ms=5, zorder=3)
        draw_numbers(panel, points(POSE, scans, column))
        draw_wearer(panel, POSE, "black", None)
        panel.set_xlim(-1, 25)
        panel.set_ylim(-2, 24)
        panel.set_title(title)
        panel.grid(False)
    for method in ("thesis", "tracker without hints", "tracker"):
        walks = [walk for (name, _), walk in groups.items() if name == method]
        rows = [row for walk in walks for row in walk]
        time = numbers(rows, "time_s")
        edges = np.arange(0, min(numbers(walk, "time_s").max() for walk in walks), 2.0)   # What is left of a few is no median.
        bins = np.digitize(time, edges) - 1
        medians = [np.median(feet(rows)[bins == i]) if (bins == i).any() else np.nan for i in range(len(edges))]
        axes[2].plot(edges + 1.0, medians, **METHODS[method])
    axes[2].axvline(SETTLE, color="#888888", ls=":", lw=1)
    axes[2].set_ylim(bottom=0)
    axes[2].set_xlabel("time, s (dotted: lights switched on; walking from 40 s)")
    axes[2].set_ylabel("location error, ft (median of walks)")
    axes[2].set_title("What it does to the estimate")
    axes[2].legend()
    return save(figure, out, "lights", "Readings with lights on and off, and the error in time")


def section(tables, out):
    groups = group(tables.rows("lights"), "method", "walk")
    scans = tables.rows("lights-scans")
    false = [float(r["on_m"]) / FEET for r in scans if disturbed(r)]
    short = len(false)
    rows = []
    medians = {}
    for method in ("thesis", "tracker without hints", "tracker"):
        fixes = [row for (name, _), walk in groups.items() if name == method for row in walk]
        time, error = numbers(fixes, "time_s"), feet(fixes)
        cells = [error[(time >= low) & (time < high)] for low, high in PARTS.values()]
        medians[method] = [np.median(c) for c in cells]
        rows.append([NAMES[method], *(f"{np.mean(c):.2f} / {np.median(c):.2f}" for c in cells)])
    text = f"""
### Case III: fluorescent lights (figures 6.25 and 6.26)

{draw(tables, groups, out)}

{table(["mean / median error, ft", *PARTS], rows)}

Room 5, 1.5 ft from the right wall and facing it, {len(group(tables.rows("lights"), "walk"))} walks. With the lights on, {short} of 15
sensors read short (orange), the same near range each time ({min(false):.0f} to {max(false):.0f} ft), as the thesis's sensors 8 and 9 did
(4 ft instead of 15 and 17.5). The
simulated ballasts are worse than the thesis's: they reach every sensor that faces a lamp. The thesis's method takes each such
reading for a wall. The tracker notices sensors that say what cannot be there and gives such readings little weight: with
steps and gyroscope its median error with the lights on is {medians["tracker"][1]:.1f} ft standing and {medians["tracker"][2]:.1f} ft walking on
through a room in which most sensors lie, by echoes alone {medians["tracker without hints"][1]:.1f} ft and
{medians["tracker without hints"][2]:.1f} ft.
"""
    return text, [("Ballasts at 47.1 kHz give false near readings", "sensors 6 to 9",
                   f"{short} of 15 sensors read short; median error {medians['thesis'][1]:.1f} ft with the thesis's method, {medians['tracker'][1]:.1f} ft with the tracker",
                   short >= 2)]
