#!/usr/bin/env python3
"""Draws a building folder (docs/formats.md), one picture a level.

    scripts/draw_building.py maps/westport-house --out build/plots

Rooms are tinted, walls black, doors blue bars across their opening, stairs and elevators orange and purple squares,
exits green triangles, places blue dots, all-reflective elements red-brown; shapes differ as well as colours (the palette
is Okabe and Ito's, which people with any kind of colour blindness tell apart). Needs matplotlib.
"""

import argparse
import json
import math
import pathlib
import subprocess
import sys

INK = "#000000"
ORANGE, SKY, GREEN, YELLOW, BLUE, VERMILION, PURPLE = (
    "#E69F00", "#56B4E9", "#009E73", "#F0E442", "#0072B2", "#D55E00", "#CC79A7")
TINTS = ["#FDF3DC", "#E4F2FB", "#E0F3EC", "#FBF9DA", "#F7E9F1", "#EEEEEE"]


def describe(echoway, folder):
    """The building as `echoway describe` places it: metres in the levels' frames."""
    result = subprocess.run([echoway, "describe", folder], capture_output=True, text=True)
    if result.returncode != 0:
        sys.exit(result.stderr.strip())
    return json.loads(result.stdout)


def area(loop):
    return 0.5 * sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(loop, loop[1:] + loop[:1]))


def label_point(outer, holes):
    """A point well inside: the best of a grid, by distance to the walls."""
    xs, ys = [p[0] for p in outer], [p[1] for p in outer]

    def inside(p, loop):
        odd = False
        for (x1, y1), (x2, y2) in zip(loop, loop[1:] + loop[:1]):
            if (y1 > p[1]) != (y2 > p[1]) and p[0] < x1 + (p[1] - y1) * (x2 - x1) / (y2 - y1):
                odd = not odd
        return odd

    def away(p, a, b):
        dx, dy = b[0] - a[0], b[1] - a[1]
        length2 = dx * dx + dy * dy
        t = max(0.0, min(1.0, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / length2)) if length2 else 0.0
        return math.hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy)

    best, most, n = (sum(xs) / len(xs), sum(ys) / len(ys)), -1.0, 14
    edges = [(a, b) for loop in [outer, *holes] for a, b in zip(loop, loop[1:] + loop[:1])]
    for i in range(n):
        for j in range(n):
            p = (min(xs) + (i + 0.5) / n * (max(xs) - min(xs)), min(ys) + (j + 0.5) / n * (max(ys) - min(ys)))
            if inside(p, outer) and not any(inside(p, hole) for hole in holes):
                d = min(away(p, a, b) for a, b in edges)
                if d > most:
                    best, most = p, d
    return best, max(most, 0.1)


def draw_room(axes, room, tint, points_per_metre):
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    loops = sorted(room["boundary"], key=lambda loop: -abs(area(loop)))
    if loops:
        vertices, codes = [], []
        for i, loop in enumerate(loops):
            turned = loop if (area(loop) > 0) == (i == 0) else loop[::-1]
            vertices += turned + [turned[0]]
            codes += [Path.MOVETO] + [Path.LINETO] * (len(loop) - 1) + [Path.CLOSEPOLY]
        axes.add_patch(PathPatch(Path(vertices, codes), facecolor=tint, edgecolor="none", zorder=1))
    for a, b in room["walls"]:
        axes.plot([a[0], b[0]], [a[1], b[1]], color=INK, lw=0.9, solid_capstyle="round", zorder=3)
    for a, b in room["reflectors"]:
        axes.plot([a[0], b[0]], [a[1], b[1]], color=VERMILION, lw=1.4, zorder=4)
    if loops:
        (x, y), radius = label_point(loops[0], loops[1:])
        text = f"{room['name']}\n{room['id']}" if room["name"] else room["id"]
        longest = max(len(line) for line in text.split("\n"))
        size = min(8.0, max(2.6, 2.6 * radius * points_per_metre / longest))
        axes.text(x, y, text, ha="center", va="center", fontsize=size, color="#333333", zorder=6, clip_on=True)


def door_bar(room, at, width):
    """The stretch of the nearest wall that a door opens."""
    def foot(wall):
        (ax, ay), (bx, by) = wall
        dx, dy = bx - ax, by - ay
        length2 = dx * dx + dy * dy
        t = max(0.0, min(1.0, ((at[0] - ax) * dx + (at[1] - ay) * dy) / length2)) if length2 else 0.0
        return math.hypot(ax + t * dx - at[0], ay + t * dy - at[1]), wall

    _, ((ax, ay), (bx, by)) = min(map(foot, room["walls"]), key=lambda pair: pair[0])
    length = math.hypot(bx - ax, by - ay) or 1.0
    ux, uy = (bx - ax) / length * width / 2, (by - ay) / length * width / 2
    return (at[0] - ux, at[1] - uy), (at[0] + ux, at[1] + uy)


def draw_doors(axes, building, rooms, level):
    for door in building["doors"]:
        for ident, at in zip(door["rooms"], door["at"]):
            room = rooms[ident]
            if room["level"] == level and room["walls"]:
                p, q = door_bar(room, at, door["width"])
                axes.plot([p[0], q[0]], [p[1], q[1]], color=SKY, lw=3.2, solid_capstyle="butt", zorder=5)


def draw_links(axes, building, level):
    shown = set()
    for link in building["links"]:
        for end in (0, 1):
            if link["levels"][end] != level:
                continue
            x, y = link["at"][end]
            up = link["levels"][1 - end] > level
            stairs = link["kind"] == "stairs"
            if (round(x, 1), round(y, 1), stairs) not in shown:
                axes.plot(x, y, "s" if stairs else "D", color=ORANGE if stairs else PURPLE, ms=7, mec=INK, mew=0.5,
                          zorder=7)
                shown.add((round(x, 1), round(y, 1), stairs))
            axes.annotate("\u2191" if up else "\u2193", (x, y), xytext=(5 if up else -9, -3), fontsize=9,
                          textcoords="offset points", zorder=8)


def draw_marks(axes, building, rooms, level):
    for mark in building["exits"]:
        if mark["level"] == level:
            axes.plot(*mark["at"], "^", color=GREEN, ms=8, mec=INK, mew=0.5, zorder=7)
            axes.annotate(mark["name"], mark["at"], xytext=(6, 4), textcoords="offset points", fontsize=5.5, zorder=8)
    for mark in building["places"]:
        if mark["level"] == level:
            axes.plot(*mark["at"], "o", color=BLUE, ms=3, zorder=7)
            if not mark["name"].startswith(rooms[mark["room"]]["name"] or "\n"):
                axes.annotate(mark["name"], mark["at"], xytext=(3, 3), textcoords="offset points", fontsize=5,
                              color=BLUE, zorder=8)


def legend(figure, columns):
    from matplotlib.lines import Line2D

    figure.legend(handles=[
        Line2D([], [], color=INK, lw=1, label="wall"),
        Line2D([], [], color=SKY, lw=3.2, label="door"),
        Line2D([], [], color=VERMILION, lw=1.4, label="all-reflective"),
        Line2D([], [], marker="s", color=ORANGE, mec=INK, ls="", label="stairs"),
        Line2D([], [], marker="D", color=PURPLE, mec=INK, ls="", label="elevator"),
        Line2D([], [], marker="^", color=GREEN, mec=INK, ls="", label="exit"),
        Line2D([], [], marker="o", color=BLUE, ls="", ms=4, label="place"),
    ], loc="upper center", bbox_to_anchor=(0.5, 0.02), ncol=columns, fontsize=7, frameon=False)


def draw_level(building, level, path, width):
    import matplotlib.pyplot as plt

    rooms = {room["id"]: room for room in building["rooms"]}
    here = [room for room in building["rooms"] if room["level"] == level]
    points = [p for room in here for wall in room["walls"] for p in wall]
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    margin = 0.03 * max(max(xs) - min(xs), max(ys) - min(ys)) + 0.3
    spread = max(xs) - min(xs) + 2 * margin
    height = max(3.0, min(1.6 * width, width * (max(ys) - min(ys) + 2 * margin) / spread))
    figure, axes = plt.subplots(figsize=(width, height))
    axes.set_xlim(min(xs) - margin, max(xs) + margin)
    axes.set_ylim(min(ys) - margin, max(ys) + margin)
    for i, room in enumerate(here):
        draw_room(axes, room, TINTS[i % len(TINTS)], 72.0 * width / spread)
    draw_doors(axes, building, rooms, level)
    draw_links(axes, building, level)
    draw_marks(axes, building, rooms, level)
    axes.set_aspect("equal")
    axes.set_title(f"{building['name']}, level {level}: {len(here)} rooms", fontsize=10)
    axes.set_xlabel("metres", fontsize=8)
    axes.tick_params(labelsize=7)
    legend(figure, 7 if width >= 7 else 4)
    figure.savefig(path, dpi=110, bbox_inches="tight")
    plt.close(figure)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("building", help="building folder")
    parser.add_argument("--out", default=".", help="folder for the pictures (default: here)")
    parser.add_argument("--level", type=int, action="append", help="only this level (may be given again)")
    parser.add_argument("--width", type=float, default=12.0, help="inches (default 12)")
    parser.add_argument("--echoway", default=str(pathlib.Path(__file__).resolve().parent.parent / "build/bin/echoway"),
                        help="the program (default: build/bin/echoway of this checkout)")
    options = parser.parse_args()
    import matplotlib

    matplotlib.use("Agg")
    building = describe(options.echoway, options.building)
    out = pathlib.Path(options.out)
    out.mkdir(parents=True, exist_ok=True)
    for level in options.level or sorted({room["level"] for room in building["rooms"]}):
        path = out / f"{pathlib.Path(options.building).resolve().name}-level-{level}.png"
        draw_level(building, level, path, options.width)
        print(path)


if __name__ == "__main__":
    main()
