"""Draws error against run time from the table that `echoway bench --csv` writes, and the page that shows both.

Usage: plot_error_against_time.py CSV --plot PNG --page MD
"""

import argparse
import os
from pathlib import Path

import machine
import matplotlib
import tables

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter  # noqa: E402

FEET = 0.3048
LOST = 3.0  # Feet: a walk whose mean error is larger has been lost for a while.
SERIES = (("bayes", "1", "tracker, motion hints", "#0072b2", "o"), ("bayes", "0", "tracker, none", "#d55e00", "s"),
          ("thesis", "0", "thesis's method", "#009e73", "D"))


def read(path):
    with open(path, encoding="utf-8") as file:
        words = file.readline().lstrip("# ").split()
    head = tables.Row(zip(words[::2], words[1::2]), path)
    defaults = {"1": int(head["default_particles"]), "0": int(head["without_hints"])}
    return float(head["one_scan_floor_m"]), defaults, tables.read(path)


def draw(floor, rows, out):
    figure, axes = plt.subplots(figsize=(8, 5))
    for method, hints, label, colour, marker in SERIES:
        points = [row for row in rows if row["method"] == method and row["hints"] == hints]
        times = [float(row["cpu_us_a_firing"]) for row in points]
        means = [float(row["mean_m"]) / FEET for row in points]
        worst = [float(row["worst_walk_m"]) / FEET for row in points]
        axes.plot(times, means, color=colour, marker=marker, label=label)
        axes.vlines(times, means, worst, color=colour, alpha=0.3)
        for row, x, y in zip(points, times, means):
            if row["particles"] != "0":
                axes.annotate(row["particles"], (x, y), textcoords="offset points", xytext=(4, 5), fontsize=7)
    axes.axhline(floor / FEET, color="#666666", linestyle="--", linewidth=1, label="Cramer-Rao floor of one scan")
    axes.set_xscale("log")
    axes.set_yscale("log")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(LogLocator(subs=(1, 2, 3, 5, 7)))
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        axis.set_minor_formatter(NullFormatter())
    axes.set_xlabel("processor time a firing, microseconds")
    axes.set_ylabel("position error, ft: mean of all walks (line up: worst walk)")
    axes.grid(True, which="both", alpha=0.25)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.12), ncols=2)
    figure.tight_layout()
    figure.savefig(out, dpi=110)


def about_budget(rows, hints, default):
    """What the sweep says of the default number of particles."""
    own = sorted((row for row in rows if row["method"] == "bayes" and row["hints"] == hints), key=lambda row: int(row["particles"]))
    loses = [int(row["particles"]) for row in own if float(row["worst_walk_m"]) / FEET > LOST]
    holding = [int(row["particles"]) for row in own if not loses or int(row["particles"]) > max(loses)]
    text = f"{default} particles {'with motion hints' if hints == '1' else 'without'}"
    measured = next(row for row in own if int(row["particles"]) == default)
    text += f" (worst walk {float(measured['worst_walk_m']) / FEET:.1f} ft)"
    if not holding:
        return text + ", though the sweep's largest budget loses a walk too"
    return text + f", where {holding[0]} and more lose none"


def page(floor, defaults, rows, plot, building):
    best = min((row for row in rows if row["hints"] == "1"), key=lambda row: float(row["mean_m"]))
    lines = ["# Error against run time", "",
             f"Written by `make bench` on {machine.name()}. The same simulated, furnished walks in "
             f"`{building}` for every line, known start. Processor time is the whole process's, so compare lines, not machines.", "",
             f"![Error against run time]({plot})", "",
             "| method | motion hints | particles | mean, ft | worst walk, ft | right room | heading | us a firing | "
             "half of them less than | time over the best's |", "|---|---|---|---|---|---|---|---|---|---|"]
    for row in rows:
        ratio = float(row["cpu_us_a_firing"]) / float(best["cpu_us_a_firing"])
        lines.append(f"| {row['method']} | {'yes' if row['hints'] == '1' else 'no'} | {row['particles']} | "
                     f"{float(row['mean_m']) / FEET:.2f} | {float(row['worst_walk_m']) / FEET:.2f} | "
                     f"{100 * float(row['right_room']):.1f} % | {float(row['heading_deg']):.1f} deg | "
                     f"{float(row['cpu_us_a_firing']):.0f} | {float(row['median_us_a_firing']):.1f} | {ratio:.2f} |")
    lines += ["", f"The default is {about_budget(rows, '1', defaults['1'])}; and {about_budget(rows, '0', defaults['0'])}. A walk is "
              f"lost when its mean error passes {LOST:.0f} ft. More is spent than most walks need, because one lost walk costs a "
              "wearer more than the time saved.",
              "", f"The Cramer-Rao floor of a single scan (15 firings, empty rooms, 1 % noise, heading known) is "
              f"{floor / FEET:.2f} ft at the median of these walks' poses. A tracker joins many scans and may pass below it; "
              "unmapped furniture, which the floor does not know, pushes it up.", "",
              "The tracker adds particles by itself while its place is uncertain, so a smaller budget that loses the wearer "
              "more often can cost more time than a larger one that holds. A search costs as much as hundreds or thousands "
              "of firings that know the place: with few particles half of all firings cost far less than the mean. The "
              "thesis's method is followed without being restarted: once it has lost the wearer it stays lost, which is "
              "what its figures show.", ""]
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("csv", type=Path)
    parser.add_argument("--building", required=True)
    parser.add_argument("--plot", required=True, type=Path)
    parser.add_argument("--page", required=True, type=Path)
    arguments = parser.parse_args()
    floor, defaults, rows = read(arguments.csv)
    draw(floor, rows, arguments.plot)
    plot = os.path.relpath(arguments.plot, arguments.page.parent)
    arguments.page.write_text(page(floor, defaults, rows, plot, arguments.building), encoding="utf-8")


if __name__ == "__main__":
    main()
