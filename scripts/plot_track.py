"""Draws a walk on its building: true path, estimated path with its uncertainty, one panel a level, and the error in time.

Usage: plot_track.py --echoway PROGRAM --building DIR --truth F --track F --out PNG
"""

import argparse
import csv
import json
import math
import subprocess
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

TRUE_COLOUR = "#0072b2"
ESTIMATE_COLOUR = "#d55e00"


def read_log(path):
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


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


def draw_level(axes, building, level, truth, track):
    for room in building["rooms"]:
        if room["level"] != level:
            continue
        for wall in room["walls"]:
            axes.plot(*zip(*wall), color="black", linewidth=0.8)
        for element in room["reflectors"]:
            axes.plot(*zip(*element), color="#999999", linewidth=2.5)
        outer = room["boundary"][0]
        centre = [sum(axis) / len(outer) for axis in zip(*outer)]
        axes.annotate(room["id"], centre, ha="center", va="center", fontsize=8, color="#666666")
    for rows, colour, label in ((truth, TRUE_COLOUR, "true"), (track, ESTIMATE_COLOUR, "estimated")):
        points = [(x, y) if row_level == level else (math.nan, math.nan) for _, row_level, x, y in rows]
        axes.plot(*zip(*points), color=colour, linewidth=1.2, label=label)
    axes.set_aspect("equal")
    axes.set_title(f"Level {level}")
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
    truth = [placed(row, rooms) for row in read_log(arguments.truth)]
    rows = read_log(arguments.track)
    track = [placed(row, rooms) for row in rows]
    levels = sorted({level for _, level, _, _ in truth})

    figure, all_axes = plt.subplots(1, len(levels) + 1, figsize=(6.5 * (len(levels) + 1), 6), squeeze=False)
    for axes, level in zip(all_axes[0], levels):
        draw_level(axes, building, level, truth, track)
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
