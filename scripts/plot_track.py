"""Draws a walk on its building: true path, estimated path with its uncertainty, one panel a level, and the error in time.

Usage: plot_track.py --echoway PROGRAM --building DIR --truth F --track F --out PNG
"""

import argparse
import json
import math
import subprocess
from pathlib import Path

import matplotlib
import tables

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

TRUE_COLOUR = "#0072b2"
ESTIMATE_COLOUR = "#d55e00"


def describe(echoway, building):
    text = subprocess.run([echoway, "describe", building], check=True, capture_output=True, text=True).stdout
    return json.loads(text)


def placed(row, rooms):
    """(time, level, x, y) of a log's row, in its level's frame."""
    room = rooms[row["room"]]
    frame_x, frame_y, turn = room["frame"]
    x, y = float(row["x_m"]), float(row["y_m"])
    cos, sin = math.cos(turn), math.sin(turn)
    return float(row["time_s"]), room["level"], frame_x + cos * x - sin * y, frame_y + sin * x + cos * y


def truth_at(truth, time, hint):
    while hint + 1 < len(truth) and truth[hint + 1][0] < time:
        hint += 1
    before, after = truth[hint], truth[min(hint + 1, len(truth) - 1)]
    share = (time - before[0]) / (after[0] - before[0]) if after[0] > before[0] else 0.0
    share = min(1.0, max(0.0, share))
    return before[2] + share * (after[2] - before[2]), before[3] + share * (after[3] - before[3]), hint


def errors(track, truth):
    hint, result = 0, []
    for time, _, x, y in track:
        true_x, true_y, hint = truth_at(truth, time, hint)
        result.append(math.hypot(x - true_x, y - true_y))
    return result


def draw_level(axes, building, level, walked, truth, track):
    """Draws the walked rooms of a level with what borders them in grey."""
    for room in building["rooms"]:
        if room["level"] != level:
            continue
        colour = "black" if room["id"] in walked else "#bbbbbb"
        for wall in room["walls"]:
            axes.plot(*zip(*wall), color=colour, linewidth=0.9)
        for element in room["reflectors"]:
            axes.plot(*zip(*element), color="#cc79a7", linewidth=2)
        outer = room["boundary"][0]
        centre = [sum(axis) / len(outer) for axis in zip(*outer)]
        label = f"{room['id']} {room['name']}".strip()
        axes.annotate(label, centre, ha="center", va="center", fontsize=8, color="#666666", annotation_clip=True)
    for door in building["doors"]:
        if door["level"] == level:
            axes.plot(*zip(*door["at"]), color="#009e73", linewidth=0, marker="s", markersize=5, zorder=2)
    for rows, style, label in ((truth, {"color": TRUE_COLOUR, "linewidth": 5, "alpha": 0.45}, "true"),
                               (track, {"color": ESTIMATE_COLOUR, "linewidth": 1.1}, "estimated")):
        points = [(x, y) if row_level == level else (math.nan, math.nan) for _, row_level, x, y in rows]
        axes.plot(*zip(*points), label=label, zorder=3, **style)
    margin = 1.0
    corners = [point for room in building["rooms"] if room["id"] in walked and room["level"] == level
               for point in room["boundary"][0]]
    xs, ys = zip(*corners)
    axes.set_xlim(min(xs) - margin, max(xs) + margin)
    axes.set_ylim(min(ys) - margin, max(ys) + margin)
    axes.set_aspect("equal")
    axes.set_title(f"Level {level}: true and estimated path (doors green)")
    axes.set_xlabel("x, m")
    axes.set_ylabel("y, m")
    axes.legend(loc="best", fontsize=8)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name in ("echoway", "building", "truth", "track", "out"):
        parser.add_argument(f"--{name}", required=True, type=Path)
    arguments = parser.parse_args()
    building = describe(arguments.echoway, arguments.building)
    rooms = {room["id"]: room for room in building["rooms"]}
    truth_rows = tables.read(arguments.truth)
    truth = [placed(row, rooms) for row in truth_rows]
    walked = {row["room"] for row in truth_rows}
    rows = tables.read(arguments.track)
    track = [placed(row, rooms) for row in rows]
    levels = sorted({level for _, level, _, _ in truth})

    figure, all_axes = plt.subplots(1, len(levels) + 1, figsize=(6.5 * (len(levels) + 1), 6), squeeze=False)
    for axes, level in zip(all_axes[0], levels):
        draw_level(axes, building, level, walked, truth, track)
    axes = all_axes[0][-1]
    times = [row[0] for row in track]
    axes.plot(times, errors(track, truth), color=ESTIMATE_COLOUR, linewidth=0.9, label="error")
    axes.plot(times, [2 * float(row["sigma_m"]) for row in rows], color="#999999", linewidth=0.9, label="2 sigma")
    axes.set_title("Position error in time")
    axes.set_xlabel("time, s")
    axes.set_ylabel("m")
    axes.set_ylim(bottom=0)
    axes.legend(loc="best", fontsize=8)
    figure.tight_layout()
    arguments.out.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(arguments.out, dpi=110)


if __name__ == "__main__":
    main()
