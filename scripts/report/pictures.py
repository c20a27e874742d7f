"""Drawings that several sections share."""

import numpy as np

from style import FEET

BELT_FT = 0.15 / FEET
ELEMENTS = {"wall": ("s", "#009e73", "simulated: wall"), "corner": ("o", "#cc79a7", "simulated: corner or edge"),
            "edge": ("o", "#cc79a7", "simulated: corner or edge"), "all-reflective": ("^", "#e69f00", "simulated: all-reflective")}


def draw_room(axes, place):
    for wall in place["walls"]:
        axes.plot(*wall.T, color="black", lw=1.2)
    for line in place["reflectors"]:
        axes.plot(*line.T, color="#e69f00", lw=1.6)
    axes.set_aspect("equal")
    axes.set_xlabel("x, ft")
    axes.set_ylabel("y, ft")


def points(pose, readings, column):
    """Where the readings lie when the wearer stands at the pose; rows without one left out."""
    x, y, heading = pose
    placed = []
    for row in readings:
        reach = float(row[column])
        if reach < 0:
            continue
        angle = heading + 2 * np.pi * int(row["sensor"]) / len(readings)
        away = reach / FEET + BELT_FT
        placed.append((x + away * np.cos(angle), y + away * np.sin(angle), row))
    return placed


def pose_of(row):
    return float(row["x_m"]) / FEET, float(row["y_m"]) / FEET, np.radians(float(row["heading_deg"]))


def draw_wearer(axes, pose, colour, label):
    x, y, heading = pose
    axes.plot(x, y, "o", color=colour, ms=6, label=label, zorder=5)
    axes.annotate("", (x + 1.3 * np.cos(heading), y + 1.3 * np.sin(heading)), (x, y),
                  arrowprops={"arrowstyle": "-|>", "color": colour, "lw": 1.4}, zorder=5)


def draw_numbers(axes, placed):
    """Sensors counted from 1, as the thesis counts them."""
    for x, y, row in placed:
        axes.annotate(str(int(row["sensor"]) + 1), (x, y), xytext=(5, 4), textcoords="offset points", fontsize=7,
                      annotation_clip=True)


def draw_match(axes, place, poses, readings, reach=None):
    """Figure 6.5's kind: real readings as diamonds, simulated ones as squares (walls) and circles (corners); of a long room
    only what lies within `reach` feet north and south of the match."""
    draw_room(axes, place)
    by_kind = {row["kind"]: pose_of(row) for row in poses}
    best = by_kind["best"]
    seen = set()
    for x, y, row in points(best, readings, "simulated_m"):
        marker, colour, label = ELEMENTS[row["element"]]
        axes.plot([best[0], x], [best[1], y], color="#eeeeee", lw=0.8, zorder=1)
        axes.plot(x, y, marker, mfc="none", mec=colour, ms=9, mew=1.5, label=None if label in seen else label, zorder=3)
        seen.add(label)
    real = points(best, readings, "real_m")
    axes.plot([p[0] for p in real], [p[1] for p in real], "D", color="#0072b2", ms=4.5, label="real (simulated world)", zorder=4)
    draw_numbers(axes, real)
    draw_wearer(axes, by_kind["true"], "black", "true pose")
    draw_wearer(axes, best, "#d55e00", "matched pose")
    walls = np.concatenate([*place["walls"], [by_kind["true"][:2], best[:2]]])
    low, high = walls.min(axis=0) - 2.5, walls.max(axis=0) + 2.5
    if reach is not None:
        low[1], high[1] = max(low[1], best[1] - reach), min(high[1], best[1] + reach)
    axes.set_xlim(low[0], high[0])
    axes.set_ylim(low[1], high[1])
    axes.grid(False)
