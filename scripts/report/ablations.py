"""What each part of the tracker buys."""

import matplotlib.pyplot as plt
import numpy as np

from data import feet, group, numbers
from style import plain_log, save, table

NOTICED = 1.1  # Factor of the mean error and of time from which a part is said to matter.


def draw(groups, out):
    shown = [g for g in groups if not g.startswith(("particles", "parts"))]
    figure, axes = plt.subplots(1, 2, figsize=(11, 0.27 * sum(len(groups[g]) + 1 for g in shown)), sharey=True)
    y, ticks = 0, []
    for name in shown:
        for level, rows in groups[name].items():
            means = feet(rows, "mean_m")
            axes[0].plot(np.sort(means), np.full(len(means), y), "|", color="#888888", ms=7)
            axes[0].plot(np.mean(means), y, "o", color="#0072b2" if "thesis" not in level else "#d55e00", ms=6)
            axes[1].plot(np.mean(numbers(rows, "cpu_us")), y, "o", color="#0072b2" if "thesis" not in level else "#d55e00", ms=6)
            ticks.append((y, f"{name}: {level}"))
            y -= 1
        y -= 0.6
    axes[0].set_yticks([t for t, _ in ticks], [label for _, label in ticks])
    axes[0].set_ylim(y, 1.0)
    for panel in axes:
        panel.set_xscale("log")
        plain_log(panel.xaxis)
    axes[0].set_xlabel("mean location error of a walk, ft (dot: mean of walks)")
    axes[1].set_xlabel("processor time a firing, µs")
    axes[0].set_title("Error")
    axes[1].set_title("Time")
    return save(figure, out, "ablations", "Error and time with parts withheld")


def short(name):
    return name.removeprefix("parts ")


def draw_parts(groups, out):
    names = [g for g in groups if g.startswith("parts")]
    levels = list(groups[names[0]])
    figure, axes = plt.subplots(1, len(names), figsize=(11, 3.6), sharey=True)
    for panel, name in zip(axes, names):
        for y, level in enumerate(levels):
            means = np.sort(feet(groups[name][level], "mean_m"))
            panel.plot(means, np.full(len(means), y), "|", color="#888888", ms=7)
            panel.plot(np.mean(means), y, "o", color="black" if level == "whole" else "#0072b2", ms=6)
        panel.axvline(np.mean(feet(groups[name]["whole"], "mean_m")), color="black", lw=0.8, ls=":")
        panel.set_xscale("log")
        plain_log(panel.xaxis)
        panel.set_title(short(name))
        panel.set_xlabel("mean location error of a walk, ft")
    axes[0].set_yticks(range(len(levels)), [level if level == "whole" else f"without: {level}" for level in levels])
    axes[0].invert_yaxis()
    return save(figure, out, "parts", "Location error without each part of the tracker; dots are means of walks, dotted the whole tracker")


def parts_table(groups):
    names = [g for g in groups if g.startswith("parts")]
    lines = []
    for level in groups[names[0]]:
        cells = [level if level == "whole" else f"without: {level}"]
        for name in names:
            own = groups[name][level]
            error = feet(own, "mean_m")
            cells.append(f"{error.mean():.2f} / {np.median(error):.2f} / {error.max():.1f} / "
                         f"{100 * numbers(own, 'right_room').mean():.0f} % / {numbers(own, 'cpu_us').mean():.0f} µs")
        lines.append(cells)
    return table(["mean / median / worst walk, ft / right room / time a firing"] + [short(name) for name in names], lines)


def listed(words):
    return ", ".join(words) if words else "none"


def verdict(groups):
    """Which parts pay where: the factor by which the mean error grows without them."""
    lines = []
    for name in (g for g in groups if g.startswith("parts")):
        whole = groups[name]["whole"]
        base, time = feet(whole, "mean_m").mean(), numbers(whole, "cpu_us").mean()
        cost = {level: feet(own, "mean_m").mean() / base for level, own in groups[name].items() if level != "whole"}
        worse = sorted((level for level in cost if cost[level] > NOTICED), key=cost.get, reverse=True)
        better = sorted((level for level in cost if cost[level] < 1 / NOTICED), key=cost.get)
        saved = {level: 1 - numbers(own, "cpu_us").mean() / time for level, own in groups[name].items() if level != "whole"}
        dear = sorted((level for level in saved if saved[level] > 1 - 1 / NOTICED), key=saved.get, reverse=True)
        lines.append(f"- *{short(name)}*: the error grows without: {listed([f'{p} ({cost[p]:.1f} times)' for p in worse])}. "
                     f"It shrinks without: {listed([f'{p} (to {cost[p]:.2f})' for p in better])}. "
                     f"Time is saved without: {listed([f'{p} ({100 * saved[p]:.0f} %)' for p in dear])}.")
    return "\n".join(lines)


def draw_budget(groups, out):
    figure, axes = plt.subplots(figsize=(7.2, 3.8))
    for name, colour in (("particles with hints", "#0072b2"), ("particles without hints", "#56b4e9")):
        levels = sorted(groups[name], key=int)
        time = [np.mean(numbers(groups[name][level], "cpu_us")) for level in levels]
        error = [np.mean(feet(groups[name][level], "mean_m")) for level in levels]
        axes.plot(time, error, "o-", color=colour, label=name.replace("particles ", ""))
        for t, e, level in zip(time, error, levels):
            axes.annotate(level, (t, e), xytext=(5, 5), textcoords="offset points", fontsize=8)
    axes.set_xscale("log")
    axes.set_yscale("log")
    plain_log(axes.xaxis)
    plain_log(axes.yaxis)
    axes.set_xlabel("processor time a firing, µs")
    axes.set_ylabel("mean location error, ft")
    axes.set_title("Number of particles: error against time")
    axes.legend()
    return save(figure, out, "particles", "Error against time for different numbers of particles")


def section(tables, out):
    rows = tables.rows("ablations")
    groups = {name: group(own, "level") for name, own in group(rows, "group").items()}
    lines = []
    for name, levels in groups.items():
        if name.startswith("parts"):
            continue
        for level, own in levels.items():
            error = feet(own, "mean_m")
            lines.append([f"{name}: {level}", f"{error.mean():.2f}", f"{np.median(error):.2f}", f"{error.max():.1f}",
                          f"{100 * numbers(own, 'right_room').mean():.1f} %", f"{numbers(own, 'turn_deg').mean():.1f}°",
                          f"{100 * numbers(own, 'within_2_sigma').mean():.0f} %", f"{numbers(own, 'cpu_us').mean():.0f}"])
    count = len({row["walk"] for row in rows})
    text = f"""
## What each part of the tracker buys

{count} random walks of about 60 s at 0.5 m/s, half in the lab, half in random offices, furnished; a mean over walks is made of a few
that are lost for a while, so mean and median are both given.

First the tracker's own parts (`TrackerParts`), switched off one at a time, in three situations: start known, with steps and gyroscope
or with echoes alone; and nothing known but the building.

{draw_parts(groups, out)}

{parts_table(groups)}

Changes of the mean error or time by less than a tenth are not counted; a change that one lost walk makes is in the mean and not in the
median:

{verdict(groups)}

A part may pay where these walks do not go: the speed of sound in warm air (below), search and proof after a wearer was carried
(last section). What follows is withheld from outside: what the tracker is told, and what the plan says.

{draw(groups, out)}

{draw_budget(groups, out)}

{table(["", "mean, ft", "median walk, ft", "worst walk, ft", "right room", "heading", "within 2 sigma", "µs a firing"], lines)}
"""
    return text, []
