#!/usr/bin/env python3
"""Draws a building folder (docs/formats.md), one picture a level.

    scripts/draw_building.py maps/westport-house --out build/plots

Rooms are tinted, walls black, doors blue bars across their opening, stairs and elevators orange and purple squares,
exits green triangles, places blue dots, all-reflective elements red-brown; shapes differ as well as colours (the palette
is Okabe and Ito's, which people with any kind of colour blindness tell apart). Needs matplotlib.
"""

import argparse
import collections
import math
import pathlib
import shlex
import sys

FOOT = 0.3048
INK = "#000000"
ORANGE, SKY, GREEN, YELLOW, BLUE, VERMILION, PURPLE = (
    "#E69F00", "#56B4E9", "#009E73", "#F0E442", "#0072B2", "#D55E00", "#CC79A7")
TINTS = ["#FDF3DC", "#E4F2FB", "#E0F3EC", "#FBF9DA", "#F7E9F1", "#EEEEEE"]

Door = collections.namedtuple("Door", "room_a at_a room_b at_b width")
Link = collections.namedtuple("Link", "kind room_a at_a room_b at_b")
Mark = collections.namedtuple("Mark", "room at name")


class Room:
    def __init__(self, ident):
        self.id = ident
        self.name = ""
        self.level = 0
        self.frame = None  # (x, y, radians) in the level's frame
        self.walls = []
        self.reflectors = []

    def to_level(self, point):
        x, y, a = self.frame
        c, s = math.cos(a), math.sin(a)
        return (x + c * point[0] - s * point[1], y + s * point[0] + c * point[1])


class Building:
    """A building folder, everything in metres."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.name = self.folder.name
        self.scale = FOOT
        self.rooms, self.doors, self.links, self.exits, self.places = {}, [], [], [], []
        lines = list(self._lines(self.folder / "building.cfg"))
        if ["units", "m"] in lines:
            self.scale = 1.0
        for path in sorted(self.folder.glob("room-*.room")):
            self._read_room(path)
        for words in lines:
            self._read_line(words)
        self._chain()

    @staticmethod
    def _lines(path):
        if not path.exists():
            return
        for line in path.read_text(encoding="utf-8").splitlines():
            lexer = shlex.shlex(line, posix=True)
            lexer.whitespace_split = True
            lexer.commenters = "#"
            lexer.quotes = '"'
            words = list(lexer)
            if words:
                yield words

    def _point(self, words):
        return (float(words[0]) * self.scale, float(words[1]) * self.scale)

    def _read_room(self, path):
        room = Room(path.stem[len("room-"):])
        for words in list(self._lines(path))[1:]:
            if words[0] in ("1", "4"):
                segment = (self._point(words[1:3]), self._point(words[3:5]))
                (room.walls if words[0] == "1" else room.reflectors).append(segment)
        self.rooms[room.id] = room

    def _read_line(self, words):
        key = words[0]
        if key == "name":
            self.name = words[1]
        elif key == "room":
            room = self.rooms[words[1]]
            room.level = int(words[3]) if len(words) > 3 else 0
            room.name = words[4] if len(words) > 4 else ""
        elif key == "frame":
            self.rooms[words[1]].frame = (*self._point(words[2:4]), math.radians(float(words[4])))
        elif key in ("stairs", "elevator"):
            self.links.append(Link(key, words[1], self._point(words[2:4]), words[4], self._point(words[5:7])))
        elif key == "exit":
            self.exits.append(Mark(words[1], self._point(words[2:4]), words[4] if len(words) > 4 else ""))
        elif key == "place":
            self.places.append(Mark(words[1], self._point(words[2:4]), words[4]))
        elif key == "door":
            self.doors.append(Door(words[1], self._point(words[2:4]), words[4], self._point(words[5:7]),
                                   float(words[8]) * self.scale if len(words) > 8 else 3 * FOOT))
        elif key != "units" and len(words) == 6:
            self.doors.append(Door(words[0], self._point(words[1:3]), words[3], self._point(words[4:6]), 3 * FOOT))

    def _chain(self):
        """Rooms without a frame are laid door to door; what no door reaches stands to the right of the rest."""
        while True:
            unplaced = [r for r in self.rooms.values() if r.frame is None]
            if not unplaced:
                return
            if not any(self._place_through(door) for door in self.doors):
                right = [p[0] for r in self.rooms.values() if r.frame and r.level == unplaced[0].level
                         for wall in r.walls for p in map(r.to_level, wall)]
                unplaced[0].frame = (max(right) + 2.0 if right else 0.0, 0.0, 0.0)

    def _place_through(self, door):
        a, b = self.rooms[door.room_a], self.rooms[door.room_b]
        for known, here, new, there in ((a, door.at_a, b, door.at_b), (b, door.at_b, a, door.at_a)):
            if known.frame and not new.frame and known.level == new.level:
                x, y = known.to_level(here)
                angle = known.frame[2]
                new.frame = (0.0, 0.0, angle)
                dx, dy = new.to_level(there)
                new.frame = (x - dx, y - dy, angle)
                return True
        return False


def rings(walls):
    """Closed loops of walls, joined end to end."""
    key = lambda p: (round(p[0], 3), round(p[1], 3))
    at = collections.defaultdict(list)
    for i, (a, b) in enumerate(walls):
        at[key(a)].append(i)
        at[key(b)].append(i)
    used, loops = set(), []
    for first in range(len(walls)):
        if first in used:
            continue
        used.add(first)
        loop = [walls[first][0], walls[first][1]]
        while key(loop[-1]) != key(loop[0]):
            following = [i for i in at[key(loop[-1])] if i not in used]
            if not following:
                break
            used.add(following[0])
            a, b = walls[following[0]]
            loop.append(b if key(a) == key(loop[-1]) else a)
        else:
            loops.append(loop[:-1])
    return loops


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

    walls = [(room.to_level(a), room.to_level(b)) for a, b in room.walls]
    loops = sorted(rings(walls), key=lambda loop: -abs(area(loop)))
    if loops:
        vertices, codes = [], []
        for i, loop in enumerate(loops):
            turned = loop if (area(loop) > 0) == (i == 0) else loop[::-1]
            vertices += turned + [turned[0]]
            codes += [Path.MOVETO] + [Path.LINETO] * (len(loop) - 1) + [Path.CLOSEPOLY]
        axes.add_patch(PathPatch(Path(vertices, codes), facecolor=tint, edgecolor="none", zorder=1))
    for a, b in walls:
        axes.plot([a[0], b[0]], [a[1], b[1]], color=INK, lw=0.9, solid_capstyle="round", zorder=3)
    for a, b in room.reflectors:
        p, q = room.to_level(a), room.to_level(b)
        axes.plot([p[0], q[0]], [p[1], q[1]], color=VERMILION, lw=1.4, zorder=4)
    if loops:
        (x, y), radius = label_point(loops[0], loops[1:])
        text = room.id if not room.name else f"{room.name}\n{room.id}"
        longest = max(len(line) for line in text.split("\n"))
        size = min(8.0, max(2.6, 2.6 * radius * points_per_metre / longest))
        axes.text(x, y, text, ha="center", va="center", fontsize=size, color="#333333", zorder=6, clip_on=True)


def door_bar(room, at, width):
    """The stretch of the nearest wall that a door opens, in the level's frame."""
    def foot(wall):
        (ax, ay), (bx, by) = wall
        dx, dy = bx - ax, by - ay
        length2 = dx * dx + dy * dy
        t = max(0.0, min(1.0, ((at[0] - ax) * dx + (at[1] - ay) * dy) / length2)) if length2 else 0.0
        return math.hypot(ax + t * dx - at[0], ay + t * dy - at[1]), wall

    _, ((ax, ay), (bx, by)) = min(map(foot, room.walls), key=lambda pair: pair[0])
    length = math.hypot(bx - ax, by - ay) or 1.0
    ux, uy = (bx - ax) / length * width / 2, (by - ay) / length * width / 2
    return room.to_level((at[0] - ux, at[1] - uy)), room.to_level((at[0] + ux, at[1] + uy))


def draw_marks(axes, building, level):
    on = lambda ident: building.rooms[ident].level == level
    for door in building.doors:
        for ident, at in ((door.room_a, door.at_a), (door.room_b, door.at_b)):
            if on(ident) and building.rooms[ident].walls:
                p, q = door_bar(building.rooms[ident], at, door.width)
                axes.plot([p[0], q[0]], [p[1], q[1]], color=SKY, lw=3.2, solid_capstyle="butt", zorder=5)
    shown = set()
    for link in building.links:
        for ident, at, other in ((link.room_a, link.at_a, link.room_b), (link.room_b, link.at_b, link.room_a)):
            if not on(ident):
                continue
            x, y = building.rooms[ident].to_level(at)
            up = building.rooms[other].level > level
            stairs = link.kind == "stairs"
            if (round(x, 1), round(y, 1), stairs) not in shown:
                axes.plot(x, y, "s" if stairs else "D", color=ORANGE if stairs else PURPLE, ms=7, mec=INK, mew=0.5,
                          zorder=7)
                shown.add((round(x, 1), round(y, 1), stairs))
            axes.annotate("\u2191" if up else "\u2193", (x, y), xytext=(5 if up else -9, -3), fontsize=9,
                          textcoords="offset points", zorder=8)
    for mark in building.exits:
        if on(mark.room):
            x, y = building.rooms[mark.room].to_level(mark.at)
            axes.plot(x, y, "^", color=GREEN, ms=8, mec=INK, mew=0.5, zorder=7)
            axes.annotate(mark.name, (x, y), xytext=(6, 4), textcoords="offset points", fontsize=5.5, zorder=8)
    for mark in building.places:
        if on(mark.room):
            x, y = building.rooms[mark.room].to_level(mark.at)
            axes.plot(x, y, "o", color=BLUE, ms=3, zorder=7)
            if not mark.name.startswith(building.rooms[mark.room].name or "\n"):
                axes.annotate(mark.name, (x, y), xytext=(3, 3), textcoords="offset points", fontsize=5, color=BLUE,
                              zorder=8)


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

    rooms = [r for r in building.rooms.values() if r.level == level]
    points = [r.to_level(p) for r in rooms for wall in r.walls for p in wall]
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    margin = 0.03 * max(max(xs) - min(xs), max(ys) - min(ys)) + 0.3
    spread = max(xs) - min(xs) + 2 * margin
    height = max(3.0, min(1.6 * width, width * (max(ys) - min(ys) + 2 * margin) / spread))
    figure, axes = plt.subplots(figsize=(width, height))
    axes.set_xlim(min(xs) - margin, max(xs) + margin)
    axes.set_ylim(min(ys) - margin, max(ys) + margin)
    for i, room in enumerate(rooms):
        draw_room(axes, room, TINTS[i % len(TINTS)], 72.0 * width / spread)
    draw_marks(axes, building, level)
    axes.set_aspect("equal")
    axes.set_title(f"{building.name}, level {level}: {len(rooms)} rooms", fontsize=10)
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
    options = parser.parse_args()
    import matplotlib

    matplotlib.use("Agg")
    building = Building(options.building)
    if not building.rooms:
        sys.exit(f"{options.building}: no room-*.room files")
    out = pathlib.Path(options.out)
    out.mkdir(parents=True, exist_ok=True)
    for level in options.level or sorted({r.level for r in building.rooms.values()}):
        path = out / f"{building.folder.name}-level-{level}.png"
        draw_level(building, level, path, options.width)
        print(path)


if __name__ == "__main__":
    main()
