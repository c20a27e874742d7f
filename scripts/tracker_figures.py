"""Puts the table that `tracker_figures.sh` writes into a page, between the lines that say so: tracker_figures.py CSV PAGE.md SECTION"""

import itertools
import sys
from pathlib import Path

import machine
import pages
import tables

FEET = 0.3048
HEAD = ("building", "start", "hints", "walks", "mean error", "worst walk", "right room", "heading", "within 2 sigma",
        "found in 20 s / 40 s", "µs a firing: half less than / mean")


def group_of(row):
    return row["building"], row["start"], row["hints"]


def mean(rows, column):
    firings = sum(int(row["firings"]) for row in rows)
    return sum(int(row["firings"]) * float(row[column]) for row in rows) / firings


def found(rows, seconds):
    return f"{sum(0 <= float(row['found_s']) <= seconds for row in rows) / len(rows):.0%}".replace("%", " %")


def line(group, rows):
    building, start, hints = group
    worst = max(float(row["error_m"]) for row in rows)
    return " | ".join((
        "", "random offices" if building == "offices" else f"`{building}`", "known pose" if start == "known" else start, hints,
        str(len(rows)), f"{mean(rows, 'error_m') / FEET:.2f} ft", f"{worst / FEET:.2f} ft", f"{100 * mean(rows, 'right_room'):.1f} %",
        f"{mean(rows, 'heading_error_deg'):.1f} deg", f"{100 * mean(rows, 'within_2_sigma'):.0f} %",
        f"{found(rows, 20)} / {found(rows, 40)}" if start == "unknown" else "",
        f"{mean(rows, 'median_us'):.0f} / {mean(rows, 'mean_us'):.0f}", "")).strip()


def figures(rows):
    table = [f"| {' | '.join(HEAD)} |", "|" + "---|" * len(HEAD)]
    table += [line(group, list(of_group)) for group, of_group in itertools.groupby(rows, group_of)]
    slowest = max(float(row["worst_us"]) for row in rows) / 1000
    return table + ["", f"Errors of unknown starts include the time before the wearer is found. Times are processor time on {machine.name()}, both "
                    f"busy; the mean includes the searches, and the slowest of all these firings took {slowest:.1f} ms."]


def main():
    table, page, section = Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3]
    text = figures(tables.read(table))
    page.write_text(pages.put(page.read_text(encoding="utf-8"), section, "tracker-figures", text), encoding="utf-8")


main()
