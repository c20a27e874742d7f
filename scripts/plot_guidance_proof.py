#!/usr/bin/env python3
"""Turns the proof of guidance into a page: plot_guidance_proof.py ROWS.csv TRACES.csv OUT_DIR

Writes OUT_DIR/guidance-proof.md (the table) and OUT_DIR/guidance-proof.png (walks and distributions).
"""
import sys
from collections import OrderedDict, defaultdict
from pathlib import Path

import matplotlib
import tables

matplotlib.use("Agg")
import matplotlib.pyplot as plt

SOURCES = OrderedDict(
    noise="truth + 0.12 m, 4° drifting error",
    obstacles="the same, furniture on the way",
    empty="tracker, bare rooms",
    furnished="tracker, furnished rooms",
    cluttered="tracker, furniture on the way",
    search="tracker told nothing, furnished rooms",
)
MODES = {"noise": "#4477aa", "obstacles": "#66ccee", "empty": "#228833", "furnished": "#ee6677", "cluttered": "#ccbb44",
         "search": "#aa3377"}
BY_TRUTH = ("noise", "obstacles")


def total(rows, column):
    return sum(float(row[column]) for row in rows)


def table(groups):
    head = (
        "| position from | building | walks | arrive | walked / shortest | wall touches a walk "
        "| bumps into furniture a walk | instructions at a wall | told from a wrong place | cues a minute | mean time, s "
        "| slowest of twenty, s | tracker error, m |\n"
        "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n"
    )
    lines = []
    for (source, name), rows in groups.items():
        n = len(rows)
        done = [row for row in rows if row["arrived"] == "1"]
        if not done:
            continue
        error = f"{total(rows, 'track_error_m') / n:.2f}" if source not in BY_TRUTH else "–"
        elsewhere = f"{100 * total(rows, 'wrong_place') / total(rows, 'leading'):.2f} %" if source not in BY_TRUTH else "–"
        times = sorted(float(row["time_s"]) for row in done)
        lines.append(
            f"| {SOURCES[source]} | {name} | {n} | {100 * len(done) / n:.1f} % "
            f"| {total(done, 'walked_m') / total(done, 'shortest_m'):.2f} | {total(rows, 'touches') / n:.2f} "
            f"| {total(rows, 'bumps') / n:.2f} | {100 * total(rows, 'wrong') / total(rows, 'instructions'):.2f} % "
            f"| {elsewhere} | {60 * total(rows, 'cues') / total(rows, 'time_s'):.0f} | {total(done, 'time_s') / len(done):.0f} "
            f"| {times[(19 * len(times)) // 20]:.0f} | {error} |"
        )
    return head + "\n".join(lines) + "\n"


def barred(groups):
    counts = {name: int(total(rows, "barred")) for (source, name), rows in groups.items() if source == "cluttered"}
    told = ", ".join(f"{count} in {name}" for name, count in counts.items() if count)
    return f"Worlds drawn again because furniture barred every way (tracker, furniture on the way): {told or 'none'}.\n"


def draw_walk(axes, traces, name, source, walk):
    walls = {(float(r["x_m"]), float(r["y_m"]), *map(float, r["text"].split())) for r in traces[name, "", "0"]}
    for x0, y0, x1, y1 in walls:
        axes.plot([x0, x1], [y0, y1], color="#555555", lw=1)
    rows = traces[name, source, walk]
    for row in (r for r in rows if r["kind"] == "thing"):
        x, y = map(float, row["text"].split())
        axes.plot([float(row["x_m"]), x], [float(row["y_m"]), y], "-", color="#b07030", lw=1.2, marker=".", ms=1.5)
    for kind, style in (("way", dict(color="#bbbbbb", lw=4, zorder=1)), ("walk", dict(color=MODES[source], lw=1.6, zorder=2))):
        points = [(float(r["x_m"]), float(r["y_m"])) for r in rows if r["kind"] == kind]
        axes.plot(*zip(*points), **style)
        if kind == "walk":
            axes.plot(*points[0], "o", color="black", ms=5)
            axes.plot(*points[-1], "*", color="black", ms=9)
    cues = [r for r in rows if r["kind"] == "cue"]
    for number, row in enumerate(cues, 1):
        axes.annotate(str(number), (float(row["x_m"]), float(row["y_m"])), fontsize=6, color="#222222",
                      xytext=(2, 2), textcoords="offset points")
    words = "\n".join(f"{i}. {r['text']}" for i, r in enumerate(cues[:24], 1))
    axes.text(1.01, 1.0, words, transform=axes.transAxes, fontsize=6, va="top")
    axes.set_aspect("equal")
    axes.axis("off")
    axes.set_title(f"{name}: {SOURCES[source]}", fontsize=8, loc="left")


def draw(groups, traces, out):
    figure = plt.figure(figsize=(13, 11))
    for i, pick in enumerate([("torgersen-lab", "furnished", "0"), ("two-rooms", "obstacles", "1")]):
        draw_walk(figure.add_axes((0.02 + 0.5 * i, 0.4, 0.3, 0.57)), traces, *pick)
    spread = figure.add_axes((0.06, 0.06, 0.4, 0.28))
    errors = figure.add_axes((0.55, 0.06, 0.4, 0.28))
    for source in SOURCES:
        rows = [r for (s, _), g in groups.items() if s == source for r in g if r["arrived"] == "1"]
        if not rows:
            continue
        ratios = sorted(float(r["walked_m"]) / float(r["shortest_m"]) for r in rows)
        share = [(i + 1) / len(ratios) for i in range(len(ratios))]
        spread.plot(ratios, share, color=MODES[source], label=SOURCES[source])
        slow = sorted(float(r["time_s"]) / float(r["shortest_m"]) for r in rows)
        errors.plot(slow, share, color=MODES[source])
    spread.axvline(1.25, color="#999999", ls=":")
    spread.set(xlabel="walked / shortest way", ylabel="share of arrivals", xlim=(0.8, 2.0), ylim=(0, 1))
    errors.set(xlabel="seconds a metre of the shortest way", ylabel="share of arrivals", xlim=(0, 15), ylim=(0, 1))
    spread.legend(fontsize=7, loc="lower right")
    figure.savefig(out, dpi=110)


def main():
    rows_file, traces_file, out = sys.argv[1:4]
    groups = OrderedDict()
    for row in tables.read(rows_file):
        groups.setdefault((row["source"], row["map"]), []).append(row)
    traces = defaultdict(list)
    for row in tables.read(traces_file):
        traces[row["map"], row["source"], row["walk"]].append(row)
    Path(out, "guidance-proof.md").write_text(
        "<!-- Written by `make guidance-proof`; do not edit. -->\n\n" + table(groups) + "\n" + barred(groups) + "\n![Walks by cues alone](guidance-proof.png)\n"
    )
    draw(groups, traces, Path(out, "guidance-proof.png"))


main()
